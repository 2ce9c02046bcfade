#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "case/case.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

/// The miss trees of a case file stand in a file beside it: X.json → X.trees.zst, and so for .jsonl
/// and .jsonl.zst. It is a sequence of zstd frames, one a tree; each case says which is its own.
/// A tree's own format is certify/checker/miss_tree.hpp.

inline constexpr const char* kTreesEnding = ".trees.zst";
/// The file of trees of a case file.
std::string trees_path(const std::string& case_path);
/// The file beside a case file whose ending is another: X.json → X + ending.
std::string path_beside(const std::string& case_path, std::string_view ending);

/// No tree comes near this; it bounds what a wrong file takes.
inline constexpr size_t kMaxTreeBytes = 4 << 20;

/// The bytes of a tree. Errors name the path: no such file; it ends before the frame does; the
/// frame is no zstd frame. The frame may also be shorter than its length or larger than
/// kMaxTreeBytes, or its bytes have another hash. Each is a limit (is_limit): nothing is known of a
/// tree that is not there.
Result<std::string> read_tree(const std::string& path, const TreeRef& tree);

/// The bytes of a truth's tree from the file `trees`; empty if it has none. Errors: as read_tree,
/// naming the field.
Result<std::string> tree_of(const Truth& truth, const std::string& trees);

/// The certificate of a truth that is a miss tree; null if it has none.
auto* miss_tree(auto& truth) {
  return truth.clearance ? std::get_if<MissTree>(&*truth.clearance) : nullptr;
}

/// For a truth whose tree does not come along: what it says of absence by that tree then rests on a
/// method's word. False: it has no tree.
bool drop_tree(Truth& truth);

/// Copies the tree of a truth, if it has one, from the file `trees` to the file beside `case_path`,
/// and makes the truth name it there. Without `trees` (empty) as drop_tree. Errors: as read_tree
/// and TreeWriter.
Result<void> carry_tree(Truth& truth, const std::string& trees, const std::string& case_path);

/// Errors: the file of path_beside is there, and another case file that it may belong to.
Result<void> refuse_shared(const std::string& case_path, std::string_view ending);

/// For a case file that has no such file beside it, in place of one that may have had: removes the
/// file of path_beside. It stays where it may belong to another case file (refuse_shared). Errors:
/// it cannot be removed, naming it.
Result<void> remove_beside(const std::string& case_path, std::string_view ending);

/// Writes the trees of a case file; the file appears whole with finish(), and only if it holds any.
class TreeWriter {
 public:
  explicit TreeWriter(const std::string& case_path) : path_(trees_path(case_path)) {}

  bool has_any() const { return file_.has_value(); }
  /// Errors: of the file, naming its path. Requires at most kMaxTreeBytes.
  Result<TreeRef> write(std::string_view bytes);
  /// Before the cases are finished, so that no case ever names a tree that is not there.
  Result<void> finish();

 private:
  std::string path_;
  std::optional<OutputFile> file_;
  std::uint64_t offset_ = 0;
};

}  // namespace ccdfuzz
