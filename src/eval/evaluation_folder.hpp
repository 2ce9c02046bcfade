#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "eval/generation_record.hpp"
#include "eval/groups.hpp"

namespace ccdfuzz {

/// What an evaluation was asked for.
struct EvaluationRun {
  std::string
      asked;  ///< all but the share, in words; shares that have it in common belong together
  std::vector<std::string> methods;
  Shard shard;
};

/// The files that an evaluation leaves in its folder. answers.csv has a line for each answer.
/// rows.jsonl has a head (what was asked, of which shard), what the cases cost to make, and a line
/// for each group of answers. tables.md has the tables as they are printed.
/// Each file appears whole or not at all, answers.csv last.
class EvaluationFolder {
 public:
  static std::string answers_path(const std::string& folder) { return folder + "/answers.csv"; }

  /// Makes the folder if need be. Errors: what the system says, naming the path.
  static Result<EvaluationFolder> open(const std::string& folder, EvaluationRun run);

  /// In the order of the cases.
  Result<void> add(const AnswerRecord& record);

  /// Must come last. costs: how the data sets were made, if that is known.
  Result<void> finish(const std::vector<GenerationCost>& costs);

  std::vector<EvaluatedGroup> groups() const { return groups_.in_order(); }

 private:
  EvaluationFolder(std::string folder, EvaluationRun run, OutputFile answers)
      : folder_(std::move(folder)),
        run_(std::move(run)),
        answers_(std::move(answers)),
        groups_(run_.methods) {}

  std::string folder_;
  EvaluationRun run_;
  OutputFile answers_;
  std::string pending_;
  Groups groups_;
};

/// A folder that EvaluationFolder left.
class EvaluatedFolder {
 public:
  /// Errors: a file is missing or is none of ours, naming it.
  static Result<EvaluatedFolder> open(const std::string& folder);

  const EvaluationRun& run() const { return run_; }
  const std::vector<GenerationCost>& costs() const { return costs_; }
  /// The answer read last; nothing at the end.
  const std::optional<AnswerRecord>& current() const { return current_; }
  /// Reads the next one. Errors: naming file, line and column.
  Result<void> advance();

 private:
  std::string folder_;
  EvaluationRun run_;
  std::vector<GenerationCost> costs_;
  std::ifstream answers_;
  size_t line_ = 0;
  std::optional<AnswerRecord> current_;
};

/// The tables as they are printed: performance, Tables 1 and 2 beside the paper's, Table 4; those
/// of which there is nothing to say are left out.
struct NamedTable {
  std::string title;
  Table table;
};
std::vector<NamedTable> evaluation_tables(const std::vector<EvaluatedGroup>& groups,
                                          const std::vector<GenerationCost>& costs);

}  // namespace ccdfuzz
