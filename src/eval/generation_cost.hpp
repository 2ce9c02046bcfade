#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "io/fields.hpp"
#include "io/table.hpp"

namespace ccdfuzz {

/// The cost of the cases of one class and kind.
struct GenerationCost {
  std::string contact;
  std::string kind;         ///< "RP+RN" where both are made of one construction
  std::uint64_t cases = 0;  ///< accepted
  std::uint64_t begun = 0;  ///< constructions
  /// Why constructions were thrown away, and how often: by step, in the order of the steps.
  std::vector<std::pair<std::string, std::uint64_t>> discarded;
  double cpu_seconds = 0;  ///< for all constructions, the discarded ones included

  static void fields(auto& archive, auto& cost) {
    archive("contact", cost.contact);
    archive("kind", cost.kind);
    archive("cases", cost.cases);
    archive("begun", cost.begun);
    archive("discarded", cost.discarded);
    archive("cpu_seconds", cost.cpu_seconds);
  }

  /// Steps that only the other one has are added.
  GenerationCost& operator+=(const GenerationCost& o);
};

/// Where the costs of a case file are: beside it, since times differ from run to run and the
/// cases do not. X.jsonl → X.jsonl.generation.jsonl. `evaluate` makes Table 4 of it.
std::string costs_path(const std::string& case_path);

/// The costs of case files, a line each, together (add_cost); none of one that has no such file.
/// Errors: it holds something else, naming file and line.
Result<std::vector<GenerationCost>> read_costs(const std::vector<std::string>& case_paths);
/// None: the file of older ones is removed. A stream has no such file. Errors: of the file.
Result<void> write_costs(const std::string& case_path, const std::vector<GenerationCost>& costs);

/// Adds a cost to that of the same class and kind, or after all others.
void add_cost(std::vector<GenerationCost>& to, const GenerationCost& cost);

/// Table 4: counts, CPU time of each accepted case with its share of what was discarded, beside the
/// paper's. And the discards of each step that had some.
Table generation_table(std::vector<GenerationCost> costs);

}  // namespace ccdfuzz
