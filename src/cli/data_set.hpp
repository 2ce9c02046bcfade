#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/hex_bytes.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "eval/generation_cost.hpp"
#include "files/case_json.hpp"
#include "files/tree_file.hpp"

namespace ccdfuzz {

/// A data set on its way into its files: cases, and beside them their miss trees. The trees appear
/// first, so that no case ever names one that is not there. Throws BadInput: of a file.
class DataSetWriter {
 public:
  /// Standard output then takes cases alone (leave_stdout_to).
  explicit DataSetWriter(const std::string& path)
      : path_(path),
        cases_(need(CaseWriter::open(path))),
        trees_(path),
        is_streamed_(is_stream(path)) {
    for (const char* ending : {kTreesEnding, kCostsEnding}) {
      if (is_streamed_) break;
      need(refuse_shared(path, ending));
      need(refuse_read_only(path_beside(path, ending)));
    }
    leave_stdout_to(path);
  }

  /// tree: the bytes of the case's miss tree, if its clearance is one; its place in the file is
  /// filled in here. A stream has no place for it (drop_tree).
  void write(Case value, const std::string& tree) {
    if (is_streamed_ && drop_tree(value.truth)) ++left_out_;
    if (MissTree* const of_tree = miss_tree(value.truth)) of_tree->tree = need(trees_.write(tree));
    need(cases_.write(value));
  }

  /// Must come last; until then none of the files is there. costs: what the cases took to make.
  /// Without, or without trees, none stay that an older file had. Says on stderr what a stream left
  /// out.
  void finish(const std::vector<GenerationCost>& costs = {}) {
    need(cases_.complete());
    if (!costs.empty()) need(write_costs(path_, costs));
    need(trees_.finish());
    need(cases_.finish());
    if (left_out_ > 0) {
      print_err(fmt::format(
          "ccdfuzz: {}: {} left out, which a stream cannot hold: use --output FILE\n", path_,
          counted(left_out_, "proof by a tree of separating axes is",
                  "proofs by trees of separating axes are")));
    }
    if (is_streamed_) return;
    if (costs.empty()) need(remove_beside(path_, kCostsEnding));
    if (!trees_.has_any()) need(remove_beside(path_, kTreesEnding));
  }

 private:
  std::string path_;
  CaseWriter cases_;
  TreeWriter trees_;
  bool is_streamed_;
  std::uint64_t left_out_ = 0;  ///< trees
};

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
  CaseCount count = {};
  std::uint64_t trees = 0;

  void add(MadeCases made);
  /// Shows what the cases cost, and then how many there are. of: behind that number.
  void show(Session& session, const std::string& of = "") const;
};

}  // namespace ccdfuzz
