#include "generators/similar.hpp"

#include <algorithm>
#include <cmath>

#include "generators/exact_sum.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// Multiplies a by 2^exponent; false if the product is rounded.
bool scale_exactly(double& a, int exponent) {
  const double scaled = std::ldexp(a, exponent);
  const bool exact = std::isfinite(scaled) && std::ldexp(scaled, -exponent) == a;
  a = scaled;
  return exact;
}

bool change_points(Points<double>& points, const Vec3<double>& by, int exponent) {
  for (Vec3<double>& p : points) {
    for (int k = 0; k < 3; ++k) {
      if (!add_exactly(p[k], by[k]) || !scale_exactly(p[k], exponent)) return false;
    }
  }
  return true;
}

/// At `until` the plane has moved by the shift and by the drift up to then.
void change_plane(MovingPlane& plane, const Similarity& change) {
  plane.offset += dot(plane.normal, exact(change.shift));
  plane.offset += plane.until * dot(plane.normal, exact(change.drift));
  plane.offset *= power_of_two(change.space);
  plane.until *= power_of_two(change.time);
}

}  // namespace

std::optional<Query> similar(const Query& query, const Similarity& change) {
  Query out = query;
  for (MovingPatch<double>& patch : out.patches) {
    if (patch.turn || !scale_exactly(patch.radius, change.space)) return std::nullopt;
    if (!change_points(patch.positions, change.shift, change.space)) return std::nullopt;
    if (patch.has_ends()) {
      const Vec3<double> none(0, 0, 0);
      if (change.time != 0 || !change_points(patch.ends, change.shift, 0) ||
          !change_points(patch.ends, change.drift, 0) ||
          !change_points(patch.ends, none, change.space)) {
        return std::nullopt;
      }
    } else if (!change_points(patch.velocities, change.drift, change.space - change.time)) {
      return std::nullopt;
    }
  }
  if (!scale_exactly(out.t_max, change.time) || !scale_exactly(out.separation, change.space)) {
    return std::nullopt;
  }
  return out;
}

std::optional<Case> similar(const Case& value, const Similarity& change) {
  const std::optional<Query> query = similar(value.query, change);
  if (!query || value.truth.contact_box) return std::nullopt;
  Case out = value;
  out.query = *query;
  const Rational unit = power_of_two(change.time);
  if (out.truth.witness) out.truth.witness->t *= unit;
  if (out.truth.clear_until) *out.truth.clear_until *= unit;
  if (auto& clearance = out.truth.clearance) {
    if (auto* plane = std::get_if<MovingPlane>(&*clearance)) {
      change_plane(*plane, change);
    } else {
      // A tree's times are multiples of a step of its own: what it proves is to be proven anew.
      clearance.reset();
      if (out.truth.proof) out.truth.proof = "rational-tdibm";
    }
  }
  out.expect.clear();
  return out;
}

std::optional<Query> begun_at(Query query, const Rational& t) {
  if (has_turns(query) || has_ends(query)) return std::nullopt;
  for (MovingPatch<double>& patch : query.patches) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        double& x = patch.positions[i][k];
        const auto moved = to_double_exactly(exact(x) + exact(patch.velocity(i)[k]) * t);
        if (!moved) return std::nullopt;
        x = *moved;
      }
    }
  }
  return query;
}

Query swapped(const Query& query) {
  Query out = query;
  std::swap(out.patches[0], out.patches[1]);
  return out;
}

Query on_other_axes(Query query, int by, std::optional<int> mirrored) {
  const auto move = [&](auto& v) { std::rotate(v.begin(), v.begin() + by, v.end()); };
  for (MovingPatch<double>& patch : query.patches) {
    for (Points<double>* points : {&patch.positions, &patch.velocities, &patch.ends}) {
      for (Vec3<double>& p : *points) {
        move(p);
        if (mirrored) p[*mirrored] = -p[*mirrored];
      }
    }
    if (patch.turn) move(patch.turn->centre), move(patch.turn->spin);
  }
  return query;
}

}  // namespace ccdfuzz
