#include "ccd/rational/units.hpp"

#include <algorithm>
#include <limits>

#include "base/double_parts.hpp"

namespace ccdfuzz::exact_ccd {

namespace {

/// Exponents of the lowest bit and above the highest bit of some doubles; empty if all are zero.
struct BitRange {
  int low = std::numeric_limits<int>::max();
  int top = std::numeric_limits<int>::min();

  bool empty() const { return low > top; }
  void include(double x) {
    const DoubleParts parts = parts_of(x);
    if (parts.mantissa == 0) return;
    low = std::min(low, parts.exponent);
    top = std::max(top, parts.top());
  }
  void include(const Points<double>& points) {
    for (const Vec3<double>& p : points) {
      for (int k = 0; k < 3; ++k) include(p[k]);
    }
  }
};

}  // namespace

Units Units::of(const Query& query) {
  constexpr int kLowest = -1074;  // exponent of the least positive double
  Units u;
  BitRange time, position, velocity;
  time.include(query.t_max);
  position.include(query.separation);
  u.horizon = time.empty() ? 0 : time.top;
  u.grid = std::max(u.horizon - kGridBits, kLowest);
  u.time = time.empty() ? u.grid : std::min(u.grid, time.low);

  for (const MovingPatch<double>& patch : query.patches) {
    position.include(patch.positions);
    velocity.include(patch.moves());
    if (patch.has_ends()) velocity.include(patch.positions);
  }
  BitRange all = position;  // and of the ways
  if (!velocity.empty()) {
    all.low = std::min(all.low, velocity.low + u.time);
    all.top = std::max(all.top, velocity.top + u.horizon);
  }
  if (all.empty()) return u;
  u.length = all.low;
  u.top = all.top;
  return u;
}

}  // namespace ccdfuzz::exact_ccd
