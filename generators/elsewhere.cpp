#include "generators/elsewhere.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/double_parts.hpp"
#include "generators/draw_patch.hpp"
#include "generators/similar.hpp"

namespace ccdfuzz {

namespace {

/// The case with a vector of short numbers as `part`: of up to 2^40 times its size, or of as much
/// as its bits allow.
Case moved(const Case& base, int size, Vec3<double> Similarity::*part, Draw& draw) {
  constexpr int kFarthest = 40, kStep = 5, kBits = 4, kMost = (1 << kBits) - 1;
  if (draw.integer(0, 1) == 0) return base;
  const int farthest = draw.integer(0, kFarthest);
  const Vec3<double> numbers = draw_integers(draw, kMost);
  for (int e = farthest; e >= 0; e -= kStep) {
    Similarity change;
    for (int k = 0; k < 3; ++k) (change.*part)[k] = std::ldexp(numbers[k], size + e - kBits);
    if (auto out = similar(base, change)) return *std::move(out);
  }
  return base;
}

/// The case in other units of length, three times of four, and of time, one time of four.
Case rescaled(const Case& base, Draw& draw) {
  Similarity change;
  if (draw.integer(0, 3) != 0) change.space = draw.integer(-1000, 900);
  if (draw.integer(0, 3) == 3) change.time = draw.integer(-100, 100);
  auto out = similar(base, change);
  return out ? *std::move(out) : base;
}

}  // namespace

int size_exponent(const Query& query) {
  double size = 0;
  const Vec3<double>& first = query.patches[0].positions[0];
  for (const MovingPatch<double>& patch : query.patches) {
    for (const Vec3<double>& p : patch.positions) {
      for (int k = 0; k < 3; ++k) size = std::max(size, std::abs(p[k] - first[k]));
    }
  }
  return parts_of(std::min(size, std::numeric_limits<double>::max())).top();
}

Case elsewhere(const Case& base, Draw& draw) {
  const int size = size_exponent(base.query);
  const Case shifted = moved(base, size, &Similarity::shift, draw);
  return rescaled(moved(shifted, size, &Similarity::drift, draw), draw);
}

}  // namespace ccdfuzz
