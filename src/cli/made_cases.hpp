#pragma once

#include <string>
#include <vector>

#include "base/hex_bytes.hpp"
#include "cli/data_set.hpp"
#include "cli/session.hpp"
#include "eval/generation_cost.hpp"
#include "files/case_json.hpp"

namespace ccdfuzz {

/// The cases of one construction and what they cost: a line of the run file of `generate`.
struct MadeCases {
  std::uint64_t index = 0;  ///< which construction of the run
  std::vector<Case> cases;
  std::string tree;  ///< bytes of the miss tree of them all, as hex digits; empty: they have none
  GenerationCost cost;

  static void fields(auto& archive, auto& made) {
    archive("index", made.index);
    archive("cases", made.cases);
    archive("tree", made.tree, [](const std::string& digits) {
      return parse_hex_bytes(digits) ? "" : "is not pairs of hex digits 0-9a-f";
    });
    archive("cost", made.cost);
  }
};

/// Made cases on their way into a data set, beside which is what they cost.
struct MadeSet {
  std::string path;
  DataSetWriter writer;  ///< finished with the costs
  std::vector<GenerationCost> costs = {};
  std::uint64_t cases = 0, trees = 0;

  Result<void> add(MadeCases made);
  /// Shows what the cases cost, and then how many there are. of: behind that number.
  void show(Session& session, const std::string& of = "") const;
};

}  // namespace ccdfuzz
