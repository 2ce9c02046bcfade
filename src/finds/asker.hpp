#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "finds/failure.hpp"
#include "method/ask.hpp"

namespace ccdfuzz {

/// Pops of one search, when methods are asked about a find of another: TDIBM needs fewer on most.
inline constexpr std::uint64_t kEnoughPops = 2000;

/// Seconds of one query, so that none holds up the end of a command, or Ctrl-C, for longer. Pops
/// alone do not bound that: one of exact arithmetic on high degrees takes 50 ms.
inline constexpr double kLongestQuerySeconds = 5;

/// What a case that failed in such a search says of how it was asked: what fails within few pops
/// does so with more.
Asked asked_with(const SearchOptions& search);

/// The cause that lost the contact of a case in the search of a method: loss_cause of its trace.
/// Empty where no contact by t_max is known, or the method cannot be traced.
std::string cause_of_loss(const std::string& method, const Case& value, TracerSet& tracers);

/// "mesh", "one-sided mesh", "spin" or "turn"; empty for other bodies.
std::string kind_of_bodies(const Query& query);

/// Asks methods about cases and says how they fail. For one thread.
class Asker {
 public:
  using CauseOfLoss = std::function<std::string(const std::string& method, const Case& value)>;

  /// cause: in place of cause_of_loss.
  explicit Asker(const SearchOptions& search, MethodSet methods = {}, CauseOfLoss cause = nullptr)
      : search_(search), methods_(std::move(methods)), cause_(std::move(cause)) {}

  Judged ask(const std::string& method, const CheckedCase& known) {
    return ask(method, known, search_);
  }
  Judged ask(const std::string& method, const CheckedCase& known, const SearchOptions& search) {
    return ccdfuzz::ask(methods_[method], known, search);
  }

  /// What an entry expects of a method that answered so about its case. It is the outcome with its
  /// cause: the name of an error, the kind of bodies, or what lost a contact.
  Expected expected(const std::string& method, const Case& value, const Judged& judged);

  /// How the method fails; nothing where it does not.
  std::optional<Failure> failure(const std::string& method, const CheckedCase& known);
  std::optional<Failure> failure(const std::string& method, const Case& value);
  /// The same, at the precision that the case says, and with no more pops than it says.
  std::optional<Failure> failure_as_asked(const std::string& method, const CheckedCase& known);
  /// The outcome of the method then.
  Expected shown_as_asked(const std::string& method, const CheckedCase& known);

  /// How deep patches pass through each other in a false negative of the method (depth_of); 0 where
  /// that is not measured.
  double depth(const std::string& method, const CheckedCase& known);

  /// Asks the methods that the find says nothing of yet, each with at most kEnoughPops, and makes
  /// the find expect what they do. What is undecided so is left out: a larger budget may decide it.
  void ask_others(Case& find, const std::vector<std::string>& methods);

  const SearchOptions& search() const { return search_; }

 private:
  std::optional<Failure> failure(const std::string& method, const CheckedCase& known,
                                 const SearchOptions& search);
  SearchOptions search_as_asked(const CheckedCase& known) const;

  SearchOptions search_;
  MethodSet methods_;
  CauseOfLoss cause_;  ///< empty: cause_of_loss
  TracerSet tracers_;
};

}  // namespace ccdfuzz
