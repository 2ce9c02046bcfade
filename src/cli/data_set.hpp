#pragma once

#include <string>
#include <vector>

#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "eval/generation_cost.hpp"
#include "files/case_json.hpp"

namespace ccdfuzz {

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

/// A data set on its way into its file, beside which is what its cases cost to make.
struct MadeSet {
  /// Standard output then takes cases alone (leave_stdout_to). Throws BadInput: as
  /// CaseWriter::open; costs beside it that could not be replaced.
  explicit MadeSet(const std::string& to);

  std::string path;
  CaseWriter writer;
  std::vector<GenerationCost> costs = {};
  CaseCount count = {};
  std::uint64_t trees = 0;

  void add(const MadeCases& made);
  /// Lets the data set appear, and its costs if there are any. Throws BadInput: of a file.
  void finish();
  /// Shows what the cases cost, and then how many there are. of: behind that number.
  void show(Session& session, const std::string& of = "") const;
};

}  // namespace ccdfuzz
