#include "certify/checker/miss_tree.hpp"

#include <algorithm>
#include <bit>

#include "base/verify.hpp"

namespace ccdfuzz {

namespace {

constexpr int kCountBits = 5;  // of an axis's number of bits
constexpr int kShiftBits = 6;
constexpr int kTimeBits = 52;
constexpr int kFirstSide = (1 << kShiftBits) - 2;

}  // namespace

std::uint64_t TreeReader::take(int bits) {
  std::uint64_t value = 0;
  for (int i = 0; i < bits; ++i, ++at_) {
    const size_t byte = at_ / 8;
    if (byte >= bytes_.size()) {
      ran_out_ = true;
      return 0;
    }
    const auto bit = static_cast<unsigned char>(bytes_[byte]) >> (at_ % 8) & 1U;
    value |= std::uint64_t{bit} << i;
  }
  return value;
}

std::int64_t TreeReader::take_signed(int bits) {
  const auto value = static_cast<std::int64_t>(take(bits));
  const std::int64_t half = std::int64_t{1} << (bits - 1);
  return value >= half ? value - 2 * half : value;
}

std::optional<TreeNode> TreeReader::next() {
  TreeNode node;
  if (take(1) == 0) {
    if (take(1) == 0) {
      const int bits = static_cast<int>(take(kCountBits)) + 1;
      axis_.emplace();
      for (std::int64_t& x : *axis_) x = take_signed(bits);
    }
    if (!axis_) return std::nullopt;
    node.axis = *axis_;
  } else if (take(1) == 0) {
    node.kind = TreeNodeKind::kSplit;
    node.side = static_cast<int>(take(1));
  } else {
    const int shift = static_cast<int>(take(kShiftBits));
    if (shift >= kFirstSide) {
      node.kind = TreeNodeKind::kOutside;
      node.side = shift - kFirstSide;
    } else {
      node.kind = TreeNodeKind::kTime;
      node.time = take(kTimeBits - shift) << shift;
    }
  }
  if (ran_out_) return std::nullopt;
  return node;
}

bool TreeReader::at_end() const {
  if ((at_ + 7) / 8 != bytes_.size()) return false;
  return at_ % 8 == 0 || static_cast<unsigned char>(bytes_.back()) >> (at_ % 8) == 0;
}

void TreeBits::put(std::uint64_t value, int bits) {
  for (int i = 0; i < bits; ++i, ++at_) {
    if (at_ % 8 == 0) bytes_ += '\0';
    const auto bit = static_cast<unsigned char>((value >> i & 1) << (at_ % 8));
    bytes_.back() = static_cast<char>(static_cast<unsigned char>(bytes_.back()) | bit);
  }
}

void TreeBits::leaf(const TreeAxis& axis) {
  put(0, 1);
  if (axis_ == axis) return put(1, 1);
  std::uint64_t largest = 0;
  for (const std::int64_t x : axis) {
    largest = std::max(largest, static_cast<std::uint64_t>(x < 0 ? -x : x));
  }
  const auto bits = static_cast<int>(std::bit_width(largest));
  CCDFUZZ_VERIFY(bits < 1 << kCountBits);
  put(0, 1);
  put(static_cast<std::uint64_t>(bits), kCountBits);
  for (const std::int64_t x : axis) put(static_cast<std::uint64_t>(x), bits + 1);
  axis_ = axis;
}

void TreeBits::split(int side) {
  put(1, 2);
  put(static_cast<std::uint64_t>(side), 1);
}

void TreeBits::outside(int side) {
  put(3, 2);
  put(static_cast<std::uint64_t>(kFirstSide + side), kShiftBits);
}

void TreeBits::time(std::uint64_t time) {
  CCDFUZZ_VERIFY(0 < time && time < kTimeSteps);
  const int shift = std::countr_zero(time);
  put(3, 2);
  put(static_cast<std::uint64_t>(shift), kShiftBits);
  put(time >> shift, kTimeBits - shift);
}

}  // namespace ccdfuzz
