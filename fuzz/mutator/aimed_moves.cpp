#include "fuzz/mutator/moves.hpp"

#include <cmath>

#include "base/double_parts.hpp"
#include "case/scale.hpp"
#include "fuzz/mutator/repair.hpp"

namespace ccdfuzz {

namespace {

MovingPatch<double>& any_patch(Contact& q, Draw& draw) {
  return q.query.patches[draw.below(2)];
}

PatchField any_field(Draw& draw) {
  return kPatchFields[draw.coin() ? 0 : 1];
}

Vec3<double>& any_point(Points<double>& points, Draw& draw) {
  return points[draw.below(points.size())];
}

int any_axis(Draw& draw) {
  return static_cast<int>(draw.below(3));
}

/// x by up to four floats up or down.
double beside(double x, Draw& draw) {
  const double end = draw.coin() ? HUGE_VAL : -HUGE_VAL;
  for (std::uint64_t steps = draw.below(5); steps > 0; --steps) x = std::nextafter(x, end);
  return x;
}

/// x in multiples of 2^unit.
double on_lattice(double x, int unit) {
  return std::ldexp(std::nearbyint(std::ldexp(x, -unit)), unit);
}

bool made_whole(Contact& q, Draw& draw) {
  return are_all(q.query, is_finite) && repair(q, draw);
}

}  // namespace

bool nudge(Contact& q, Draw& draw) {
  for (std::uint64_t left = 1 + draw.below(3); left > 0; --left) {
    MovingPatch<double>& patch = any_patch(q, draw);
    Vec3<double>& p = any_point(any_field(draw)(patch), draw);
    const int k = any_axis(draw);
    p[k] = beside(p[k], draw);
  }
  return made_whole(q, draw);
}

bool make_twins(Contact& q, Draw& draw) {
  const PatchField field = any_field(draw);
  const Vec3<double> model = any_point(field(any_patch(q, draw)), draw);
  Vec3<double>& p = any_point(field(any_patch(q, draw)), draw);
  const bool one_axis_only = draw.coin();
  const int axis = any_axis(draw);
  for (int k = 0; k < 3; ++k) {
    if (!one_axis_only || k == axis) p[k] = beside(model[k], draw);
  }
  return made_whole(q, draw);
}

bool align_edge(Contact& q, Draw& draw) {
  MovingPatch<double>& patch = any_patch(q, draw);
  const size_t i = draw.below(patch.positions.size()), j = draw.below(patch.positions.size());
  const int axis = any_axis(draw);
  if (i == j) return false;
  for (int k = 0; k < 3; ++k) {
    if (k == axis) continue;
    patch.positions[i][k] = patch.positions[j][k];
    patch.moves()[i][k] = patch.moves()[j][k];
  }
  return made_whole(q, draw);
}

bool flatten(Contact& q, Draw& draw) {
  Points<double>& points = any_field(draw)(any_patch(q, draw));
  const int k = any_axis(draw);
  const double level = any_point(points, draw)[k];
  for (Vec3<double>& p : points) p[k] = level;
  return made_whole(q, draw);
}

bool collapse(Contact& q, Draw& draw) {
  MovingPatch<double>& patch = any_patch(q, draw);
  const size_t to = draw.below(patch.positions.size());
  const size_t first = draw.below(patch.positions.size());
  const size_t count = 1 + draw.below(3);
  for (size_t i = first; i < std::min(first + count, patch.positions.size()); ++i) {
    patch.positions[i] = patch.positions[to];
    patch.moves()[i] = patch.moves()[to];
  }
  return made_whole(q, draw);
}

bool snap_to_lattice(Contact& q, Draw& draw) {
  Points<double>& points = any_field(draw)(any_patch(q, draw));
  const double size = any_point(points, draw).cwiseAbs().maxCoeff();
  if (size == 0) return false;
  const int unit = std::ilogb(size) - static_cast<int>(draw.below(20));
  for (Vec3<double>& p : draw.coin() ? std::span(points) : std::span(&any_point(points, draw), 1)) {
    for (int k = 0; k < 3; ++k) p[k] = on_lattice(p[k], unit);
  }
  return made_whole(q, draw);
}

bool stop_motion(Contact& q, Draw& draw) {
  const size_t s = draw.below(2);
  if (has_ends(q.query)) return false;
  const Vec3<double> velocity =
      draw.coin() ? any_point(q.query.patches[s].velocities, draw) : Vec3<double>(0, 0, 0);
  const bool both = draw.coin();
  for (size_t side = 0; side < 2; ++side) {
    if (side != s && !both) continue;
    for (Vec3<double>& v : q.query.patches[side].velocities) v = velocity;
  }
  return made_whole(q, draw);
}

bool stretch(Contact& q, Draw& draw) {
  Vec3<double>& p = any_point(any_field(draw)(any_patch(q, draw)), draw);
  const int exponent = draw.integer(-40, 20);
  const bool one_axis_only = draw.coin();
  const int axis = any_axis(draw);
  for (int k = 0; k < 3; ++k) {
    if (!one_axis_only || k == axis) p[k] = std::ldexp(p[k], exponent);
  }
  return made_whole(q, draw);
}

}  // namespace ccdfuzz
