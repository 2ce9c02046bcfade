#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "eval/evaluated_case.hpp"
#include "eval/tally.hpp"

namespace ccdfuzz {

/// "RP+RN" for the regular kinds, "NHP+NMN" for the grazing ones, as the halves of Table 2; any
/// other kind by itself.
std::string kinds_of(const std::string& kind);

/// What is summed up: all answers of a method to the cases of one contact class and of kinds that
/// belong together, at one horizon.
struct EvaluatedGroup {
  std::string contact;  ///< "-" if the case does not say
  std::string kinds;
  std::optional<double> factor;
  std::string method;
  Tally tally;
  Samples seconds;
  Samples bytes;

  void add(const GivenAnswer& given, std::optional<bool> collides);
  void merge(const EvaluatedGroup& other);
};

/// The groups of an evaluation, in the order: contact classes of the paper, then others by name;
/// kinds, the regular ones first; horizons; methods as they first
/// came.
class Groups {
 public:
  void add(const EvaluatedCase& evaluated);
  std::vector<EvaluatedGroup> in_order() const;

 private:
  using Key = std::tuple<size_t, std::string, size_t, std::string, std::optional<double>, size_t>;

  std::vector<std::string> methods_;
  std::map<Key, EvaluatedGroup> groups_;
};

/// The groups at the contact itself, or as given, those of one class and method as one: all kinds,
/// or only those of `kinds`.
std::vector<EvaluatedGroup> at_contact(const std::vector<EvaluatedGroup>& groups,
                                       const std::optional<std::string>& kinds);

}  // namespace ccdfuzz
