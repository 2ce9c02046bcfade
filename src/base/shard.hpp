#pragma once

#include <cstdint>

namespace ccdfuzz {

/// One of `of` equal shares of a run: of items 0, 1, 2, … every of-th one, beginning with `index`,
/// so that slow stretches are shared too. Together the shares are the run, and none overlap.
struct Shard {
  std::uint64_t index = 0;  ///< < of
  std::uint64_t of = 1;

  bool is_whole() const { return of == 1; }
  /// How many of `total` items it has.
  std::uint64_t size(std::uint64_t total) const {
    return total / of + (index < total % of ? 1 : 0);
  }
  /// Its k-th item.
  std::uint64_t item(std::uint64_t k) const { return index + k * of; }

  static void fields(auto& archive, auto& shard) {
    archive("index", shard.index);
    archive("of", shard.of);
  }

  friend bool operator==(const Shard&, const Shard&) = default;
};

}  // namespace ccdfuzz
