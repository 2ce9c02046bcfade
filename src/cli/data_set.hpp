#pragma once

#include <string>
#include <vector>

#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "eval/generation_cost.hpp"
#include "files/case_json.hpp"

namespace ccdfuzz {

/// A data set on its way into its file. Standard output then takes cases alone (leave_stdout_to).
/// Throws BadInput: as CaseWriter::open; costs beside it that could not be replaced.
CaseWriter data_set_writer(const std::string& path);

/// Lets the data set appear. Beside it stays what its cases cost to make, and nothing without
/// costs. Throws BadInput: of a file.
void finish_data_set(CaseWriter& cases, const std::string& path,
                     const std::vector<GenerationCost>& costs = {});

/// The cases of one construction and what they cost: a line of the run file of `generate`.
struct MadeCases {
  std::uint64_t index = 0;  ///< which construction of the run
  std::vector<Case> cases;
  GenerationCost cost;

  static void fields(auto& archive, auto& made) {
    archive("index", made.index);
    archive("cases", made.cases);
    archive("cost", made.cost);
  }
};

/// Made cases on their way into a data set, beside which is what they cost.
struct MadeSet {
  explicit MadeSet(const std::string& to) : path(to), writer(data_set_writer(to)) {}

  std::string path;
  CaseWriter writer;
  std::vector<GenerationCost> costs = {};
  CaseCount count = {};
  std::uint64_t trees = 0;

  void add(const MadeCases& made);
  /// As finish_data_set.
  void finish() { finish_data_set(writer, path, costs); }
  /// Shows what the cases cost, and then how many there are. of: behind that number.
  void show(Session& session, const std::string& of = "") const;
};

}  // namespace ccdfuzz
