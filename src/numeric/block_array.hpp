#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace ccdfuzz {

/// What a solver keeps of its buffers between queries, at most. (A thread that runs the oracle has
/// three solvers, of which two are its own: src/certify/oracle/oracle.cpp, proves_clear.cpp.)
inline constexpr std::size_t kKeptBytes = 16 << 20;

/// An array that grows at its end, in blocks that stay where they are: growing copies nothing.
/// Items are `width` numbers of type T in a row, not initialised. It holds what is in use, less
/// than a block more, and the ends of blocks. These are below a sixth for the nets of any degrees.
template <class T>
class BlockArray {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

 public:
  static constexpr std::size_t kBlockBytes = 64 << 10;

  BlockArray() { reset(); }

  /// Without items; keeps the memory. Requires 1 ≤ width and 4·width·sizeof(T) ≤ kBlockBytes.
  void reset(std::size_t width = 1) {
    constexpr std::size_t kFamily = 4;
    size_ = 0;
    width_ = width;
    per_block_ = kBlockBytes / (kFamily * width * sizeof(T)) * kFamily;
    reciprocal_ = ~std::uint64_t{0} / per_block_ + 1;
  }

  std::size_t size() const { return size_; }
  /// Items that are taken up again are not what they were. Requires size < 2^32.
  void resize(std::size_t size) {
    while (blocks_.size() * per_block_ < size) {
      blocks_.push_back(std::make_unique_for_overwrite<std::byte[]>(kBlockBytes));
    }
    size_ = size;
  }

  /// Item i < size(). Four items from a multiple of 4 on are in a row, as are two from one of 2.
  T* operator[](std::size_t i) { return item(i); }
  const T* operator[](std::size_t i) const { return item(i); }

  /// Bytes of memory in all blocks.
  std::size_t held() const { return blocks_.size() * kBlockBytes; }
  /// Gives back the blocks beyond so many bytes, but for those in use.
  void keep_at_most(std::size_t bytes) {
    const std::size_t in_use = (size_ + per_block_ - 1) / per_block_;
    const std::size_t kept = std::max(in_use, bytes / kBlockBytes);
    if (kept >= blocks_.size()) return;
    blocks_.resize(kept);
    blocks_.shrink_to_fit();
  }

 private:
  __extension__ using Product = unsigned __int128;

  T* item(std::size_t i) const {
    // i / per_block_, rounded down: the reciprocal of n is (2^64 + d)/n with 0 ≤ d < n, so that the
    // product is i/n and less than i·2^-64 < 2^-32 < 1/n more.
    const auto block = static_cast<std::size_t>(Product{reciprocal_} * i >> 64);
    return reinterpret_cast<T*>(blocks_[block].get()) + (i - block * per_block_) * width_;
  }

  std::vector<std::unique_ptr<std::byte[]>> blocks_;
  std::size_t size_ = 0, width_ = 1, per_block_ = 0;
  std::uint64_t reciprocal_ = 0;
};

}  // namespace ccdfuzz
