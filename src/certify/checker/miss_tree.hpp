#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "case/certificate.hpp"

namespace ccdfuzz {

/// The bytes of certificate T. Bits are read from the lowest of each byte; after the root's subtree
/// there are fewer than 8 of them, all 0. A node stands for a part of each patch and a closed
/// window of times [lo, hi]; the root for both patches and [0, kTimeSteps]. Times are integers, in
/// steps of until / kTimeSteps. In pre-order:
///   0 axis         leaf: the axis separates patch 1, below, from patch 2, above, throughout
///   1 0 side       the part of patch 1 (side 0) or 2 (side 1) is split at the midpoints of its
///                  parameters; a child for each of its parts, in the order of Cell::child
///   1 1 time       two children, for [lo, time] and [time, hi]; lo < time < hi
///   1 1 side       leaf: the part of patch 1 (62) or 2 (63) is outside of the patch's trim
/// axis: 1 for that of the leaf before, or 0, then 5 bits b, then three integers of b+1 bits each,
/// two's complement. time: 6 bits s, then 52−s bits, the time being those times 2^s.
/// side: 6 bits, which are more than any s.
inline constexpr std::uint64_t kTimeSteps = std::uint64_t{1} << 52;

/// Nodes deeper than this are refused; it bounds the checker's stack.
inline constexpr int kMaxTreeDepth = 1000;

/// A part is the result of at most so many splits, as numbers grow with each. Searches, and with
/// them those who write trees, end at 50 (Cell::kMaxDepth), where doubles cannot tell parts apart.
inline constexpr int kMaxPartDepth = 60;

using TreeAxis = std::array<std::int64_t, 3>;

enum class TreeNodeKind : std::uint8_t { kLeaf, kSplit, kTime, kOutside };

struct TreeNode {
  TreeNodeKind kind = TreeNodeKind::kLeaf;
  int side = 0;            ///< split, outside
  std::uint64_t time = 0;  ///< time
  TreeAxis axis{};         ///< leaf

  friend bool operator==(const TreeNode&, const TreeNode&) = default;
};

/// Reads nodes one after the other; whether they make a tree is for the caller to say.
class TreeReader {
 public:
  explicit TreeReader(std::string_view bytes) : bytes_(bytes) {}

  /// Nothing if the bytes end before the node does, or its axis refers to none.
  std::optional<TreeNode> next();
  /// True iff nothing is left but padding.
  bool at_end() const;

 private:
  std::uint64_t take(int bits);
  std::int64_t take_signed(int bits);

  std::string_view bytes_;
  size_t at_ = 0;  ///< in bits
  bool ran_out_ = false;
  std::optional<TreeAxis> axis_;
};

/// Writes what TreeReader reads.
class TreeBits {
 public:
  void leaf(const TreeAxis& axis);  ///< components below 2^31 in magnitude
  void split(int side);
  void outside(int side);
  void time(std::uint64_t time);  ///< 0 < time < kTimeSteps
  const std::string& bytes() const { return bytes_; }

 private:
  void put(std::uint64_t value, int bits);

  std::string bytes_;
  size_t at_ = 0;
  std::optional<TreeAxis> axis_;
};

}  // namespace ccdfuzz
