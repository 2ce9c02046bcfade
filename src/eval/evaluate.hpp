#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/shard.hpp"
#include "eval/rows.hpp"
#include "files/case_files.hpp"
#include "io/run_file.hpp"
#include "method/method_set.hpp"

namespace ccdfuzz {

/// A case of a share, with its answers if an earlier run gave them.
struct CaseToEvaluate : NamedCase {
  struct Line {
    std::string where, json;
  };
  std::uint64_t index = 0;  ///< in the data set
  std::optional<Line> line;
};

inline bool is_anew(const CaseToEvaluate& item) {
  return !item.line;
}

/// The cases of a share of a data set, one after the other.
class CasesToEvaluate {
 public:
  /// earlier: the answers to the first cases of the share, which need not be asked; null: none.
  CasesToEvaluate(const std::vector<std::string>& files, const Shard& shard, RunLines* earlier)
      : cases_(files), shard_(shard), earlier_(earlier) {}

  /// The next case; nothing at the end. Errors: as CaseStream and RunLines.
  Result<std::optional<CaseToEvaluate>> next();

 private:
  CaseStream cases_;
  Shard shard_;
  RunLines* earlier_;
  std::uint64_t index_ = 0;  ///< of the next case
};

struct EvaluateOptions {
  std::vector<std::string> methods;  ///< parsed specs
  /// Multiples ≥ 1 of the time by which a contact is known, to ask a case up to. Without a contact
  /// it is asked once, unchanged. Empty: every case is.
  std::vector<double> horizon_factors;
  /// Limits of one case.
  std::function<SearchOptions(const Case&)> search_for;
};

/// The answers to a case, by horizon and then by method. Checks it (decided_and_checked), and asks
/// every method unless an earlier run did. Errors: it is refuted; its line is of another case.
Result<EvaluatedCase> evaluated(CaseToEvaluate& item, const EvaluateOptions& options,
                                MethodSet& methods);

}  // namespace ccdfuzz
