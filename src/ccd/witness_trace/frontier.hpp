#pragma once

#include <array>

#include "ccd/search.hpp"
#include "ccd/witness_trace/witness_path.hpp"

namespace ccdfuzz {

/// Room for the pairs of one level that contain a witness. At most six cells of a triangle meet in
/// a point, at most four of a tensor patch; and two halves of a window in a time.
inline constexpr size_t kMostOfLevel = 6 * 6 * 2;

/// The pairs of children that contain a witness: all of them, or the lowest of each patch alone.
class ChildChoices {
 public:
  ChildChoices(const WitnessPath& path, const PairParts& parts, bool all) {
    std::array<std::array<int, 4>, 2> found{};
    std::array<size_t, 2> count{};
    for (size_t s = 0; s < 2; ++s) {
      for (int c = 0; c < parts.count[s]; ++c) {
        if (!path.in(static_cast<int>(s), parts.cells[s][static_cast<size_t>(c)])) continue;
        found[s][count[s]++] = c;
        if (!all) break;
      }
    }
    for (size_t a = 0; a < count[0]; ++a) {
      for (size_t b = 0; b < count[1]; ++b) pairs_[size_++] = {found[0][a], found[1][b]};
    }
  }

  const std::array<int, 2>* begin() const { return pairs_.data(); }
  const std::array<int, 2>* end() const { return pairs_.data() + size_; }

 private:
  std::array<std::array<int, 2>, 16> pairs_;
  size_t size_ = 0;
};

}  // namespace ccdfuzz
