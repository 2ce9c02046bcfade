#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/shard.hpp"
#include "case/checked_case.hpp"
#include "ccd/search.hpp"
#include "eval/rows.hpp"
#include "files/case_files.hpp"
#include "io/run_file.hpp"

namespace ccdfuzz {

struct EvaluateOptions {
  std::vector<std::string> methods;  ///< parsed specs
  /// Multiples ≥ 1 of the witness's time to ask a case up to. Without a witness it is asked once,
  /// unchanged. Empty: every case is.
  std::vector<double> horizon_factors;
  /// Limits of one case.
  std::function<SearchOptions(const Case&)> search_for;
  Shard shard;  ///< the part of the cases
  int threads = 1;
};

/// Sees a case and its answers. is_new: no earlier run gave them.
using OnEvaluated = std::function<Result<void>(const NamedCase& named,
                                               const EvaluatedCase& evaluated, bool is_new)>;

/// earlier: the answers to the first cases of the share, which need not be asked; null: none.
/// Checks every case of the share (decide_unknown, check_case) and asks every method about it.
/// on_case sees the cases in their order, the answers by horizon and then by method, whatever the
/// number of threads. Everything but times is the same in every run. Holds a few cases at a time.
/// Once stop() is true no more is read, and what was begun still reaches on_case. Errors: of
/// reading; the first case that is refuted, naming it; a line that is not of the next case; of
/// on_case.
Result<void> evaluate(const std::vector<std::string>& files, const EvaluateOptions& options,
                      RunLines* earlier, const OnEvaluated& on_case,
                      const std::function<bool()>& stop);

}  // namespace ccdfuzz
