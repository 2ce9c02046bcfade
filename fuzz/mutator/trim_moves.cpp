#include <cmath>

#include "bezier/trim.hpp"
#include "fuzz/mutator/moves.hpp"
#include "generators/draw_trim.hpp"

namespace ccdfuzz {

namespace {

template <class Items>
auto any_place(const Items& items, Draw& draw) {
  return static_cast<std::ptrdiff_t>(draw.below(items.size()));
}

}  // namespace

bool change_trim(Contact& q, Draw& draw) {
  const size_t side = draw.below(2);
  MovingPatch<double>& patch = q.query.patches[side];
  if (patch.shape.parameter_count() != 2) return false;
  Trim& trim = patch.trim;
  const std::uint64_t kind = trim.empty() ? 0 : draw.below(5);
  if (kind == 0) {
    const auto u = q.uv[side][0].to_double_exactly(), v = q.uv[side][1].to_double_exactly();
    if (!u || !v) return false;
    trim.push_back(loop_about(patch.shape, {*u, *v}, static_cast<int>(draw.below(12))));
  } else if (kind == 1) {
    trim.erase(trim.begin() + any_place(trim, draw));
  } else {
    auto& loop = trim[draw.below(trim.size())];
    const std::ptrdiff_t i = any_place(loop, draw);
    const auto at = static_cast<size_t>(i);
    if (kind == 2) {
      loop.erase(loop.begin() + i);
    } else if (kind == 3) {
      const Uv<double>&a = loop[at], &b = loop[(at + 1) % loop.size()];
      loop.insert(loop.begin() + i + 1, {0.5 * a[0] + 0.5 * b[0], 0.5 * a[1] + 0.5 * b[1]});
    } else {
      double& x = loop[at][draw.below(2)];
      x = std::nextafter(x, draw.coin() ? 2.0 : -1.0);
    }
  }
  return !fault_of(trim, patch.shape) && is_in_trims(q);
}

}  // namespace ccdfuzz
