#pragma once

#include <string>

#include "files/case_files.hpp"
#include "files/tree_file.hpp"

namespace ccdfuzz {

/// A data set on its way into its files: cases, and beside them their miss trees. The trees appear
/// first, so that no case ever names one that is not there.
class DataSetWriter {
 public:
  /// Errors: as CaseWriter::open.
  static Result<DataSetWriter> open(const std::string& path) {
    return CaseWriter::open(path).map(
        [&](CaseWriter writer) { return DataSetWriter(std::move(writer), path); });
  }

  /// tree: the bytes of the case's miss tree, if its clearance is one; its place in the file is
  /// filled in here. A stream has no place for it (drop_tree).
  Result<void> write(Case value, const std::string& tree) {
    if (is_streamed_) drop_tree(value.truth);
    if (value.truth.clearance) {
      if (auto* of_tree = std::get_if<MissTree>(&*value.truth.clearance)) {
        CCDFUZZ_TRY(of_tree->tree, trees_.write(tree));
      }
    }
    return cases_.write(value);
  }

  /// As CaseWriter::complete.
  Result<void> complete() { return cases_.complete(); }
  /// Must come last; until then neither file is there.
  Result<void> finish() {
    return complete().and_then([this] { return trees_.finish(); }).and_then([this] {
      return cases_.finish();
    });
  }

 private:
  DataSetWriter(CaseWriter cases, const std::string& path)
      : cases_(std::move(cases)), trees_(path), is_streamed_(is_stream(path)) {}

  CaseWriter cases_;
  TreeWriter trees_;
  bool is_streamed_;
};

}  // namespace ccdfuzz
