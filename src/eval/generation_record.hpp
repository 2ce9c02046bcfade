#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "base/shard.hpp"
#include "base/table.hpp"

namespace ccdfuzz {

/// What the cases of one class and kind cost.
struct GenerationCost {
  std::string contact;
  std::string kind;         ///< "RP+RN" where both are made of one construction
  std::uint64_t cases = 0;  ///< accepted
  std::uint64_t begun = 0;  ///< constructions
  /// Why constructions were thrown away, step by step.
  std::vector<std::pair<std::string, std::uint64_t>> discarded;
  double cpu_seconds = 0;  ///< of all constructions, the discarded ones included

  /// Requires the same steps.
  GenerationCost& operator+=(const GenerationCost& o);
};

/// A cost as a JSON object on one line.
std::string to_json(const GenerationCost& cost);
/// The cost on such a line. Errors: it is none, at `where`.
Result<GenerationCost> parse_cost(const std::string& line, const std::string& where);

/// How a data set was made. It stands in a file beside the cases, since times differ from run to
/// run and the cases do not: X.jsonl.zst → X.generation.jsonl, and so for .jsonl. Its first line
/// is {"format", "version", "run", "shard"}, each further one a cost.
struct GenerationRecord {
  std::string run;  ///< what was asked for; pieces that have it in common belong together
  Shard shard;
  std::vector<GenerationCost> costs;  ///< in the order of the cases
};

/// Where the record of a case file stands.
std::string generation_path(const std::string& case_path);

/// The record at a path; nothing if there is no file. Errors: it is none; naming file and line.
Result<std::optional<GenerationRecord>> read_generation(const std::string& path);
Result<void> write_generation(const std::string& path, const GenerationRecord& record);

/// Adds the costs of one record to those of another, class by class and kind by kind.
void merge_costs(std::vector<GenerationCost>& into, const std::vector<GenerationCost>& from);

/// Table 4: counts, CPU time of each accepted case with its share of what was discarded, beside the
/// paper's, and the discards of each step.
Table generation_table(const std::vector<GenerationCost>& costs);

}  // namespace ccdfuzz
