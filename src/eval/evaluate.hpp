#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/ask.hpp"
#include "eval/table.hpp"
#include "eval/tally.hpp"
#include "query/case_files.hpp"

namespace ccdfuzz {

struct EvaluateOptions {
  std::vector<std::string> methods;  ///< parsed specs
  /// Multiples ≥ 1 of the contact's time to ask positive cases up to; negative cases are asked
  /// once, as they stand. Empty: every case is asked once, as it stands.
  std::vector<double> horizon_factors;
  SearchOptions search;
  int threads = 1;
};

/// One answer of the evaluation. The factor is absent where the case was asked as it stands.
struct EvaluatedRow {
  const NamedCase* source = nullptr;
  std::optional<double> factor;
  std::string method;
  double t_max = 0;
  Judged judged;
};

/// What is summed up: all answers of a method to the cases of one contact class at one horizon.
struct EvaluatedGroup {
  std::string contact;  ///< "-" if the case does not say
  std::optional<double> factor;
  std::string method;
  Tally tally;
  Timings timings;
};

/// Puts every case to every method. on_row sees the answers in the order of the cases, within a
/// case of the horizons, within those of the methods, whatever the number of threads; share is how
/// much is done. Groups come in the order: contact classes of the paper, then others by name;
/// horizons; methods. Everything but times is the same in every run. stop ends it early, with
/// what was answered until then.
std::vector<EvaluatedGroup> evaluate(
    const std::vector<NamedCase>& cases, const EvaluateOptions& options,
    const std::function<void(const EvaluatedRow&, double share)>& on_row,
    const std::atomic<bool>* stop = nullptr);

/// The shape of Table 1: a row for each group.
Table performance_table(const std::vector<EvaluatedGroup>& groups);

/// False positives, and false negatives where the query ends at the contact, as rates beside those
/// of the paper's Table 2. Groups at longer horizons have no row.
Table paper_table(const std::vector<EvaluatedGroup>& groups);

}  // namespace ccdfuzz
