#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/shard.hpp"
#include "case/case_files.hpp"
#include "ccd/search.hpp"
#include "eval/answer_record.hpp"

namespace ccdfuzz {

struct EvaluateOptions {
  std::vector<std::string> methods;  ///< parsed specs
  /// Multiples ≥ 1 of the contact's time to ask positive cases up to; negative cases are asked
  /// once, as they stand. Empty: every case is asked once, as it stands.
  std::vector<double> horizon_factors;
  SearchOptions search;
  /// Limits of one case; empty: `search` for all.
  std::function<SearchOptions(const Case&)> search_for = {};
  Shard shard;             ///< of the cases
  std::uint64_t skip = 0;  ///< that many answers are known already
  int threads = 1;
};

/// Checks every case of the share (check_case) and puts it to every method. on_answer sees the
/// answers in the order of the cases, within a case of the horizons, within those of the methods,
/// whatever the number of threads; share is how much is done. Everything but times is the same in
/// every run. stop ends it early. Returns true iff all has been answered. Errors: the first case
/// that is refuted, naming it.
Result<bool> evaluate(const std::vector<NamedCase>& cases, const EvaluateOptions& options,
                      const std::function<void(const AnswerRecord&, double share)>& on_answer,
                      const std::atomic<bool>* stop = nullptr);

}  // namespace ccdfuzz
