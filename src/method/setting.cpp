#include "method/setting.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bezier/bernstein.hpp"
#include "case/mesh.hpp"
#include "case/scale.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/feature_depth.hpp"
#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {

namespace {

/// Control point i at time t, rounded.
Vec3<double> position_at(const MovingPatch<double>& patch, size_t i, double t) {
  return patch.positions[i] + t * rounded_velocity(patch, i);
}

/// Whether the control points of a patch at time t are as good as one point or, of a surface, as
/// points of a line. Rounded: it says how convincing a query is and decides nothing.
bool is_flat(const MovingPatch<double>& patch, double t) {
  const auto at = [&](size_t i) { return position_at(patch, i, t); };
  const Vec3<double> origin = at(0);
  Vec3<double> longest{0, 0, 0};
  for (size_t i = 1; i < patch.positions.size(); ++i) {
    const Vec3<double> side = at(i) - origin;
    if (side.squaredNorm() > longest.squaredNorm()) longest = side;
  }
  const double length2 = longest.squaredNorm();
  const int parameters = patch.shape.parameter_count();
  if (parameters < 2) return parameters == 1 && length2 == 0;
  double area2 = 0;
  for (size_t i = 1; i < patch.positions.size(); ++i) {
    area2 = std::max(area2, longest.cross(Vec3<double>(at(i) - origin)).squaredNorm());
  }
  return std::sqrt(area2) <= kThinnest * length2;
}

bool is_at_rest(const Query& query) {
  if (has_turns(query)) return false;
  const Vec3<double> velocity = rounded_velocity(query.patches[0], 0);
  for (const MovingPatch<double>& patch : query.patches) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      if (rounded_velocity(patch, i) != velocity) return false;
    }
  }
  return true;
}

/// Directions of length 1 that are perpendicular to each other, as many as those added span.
class Span {
 public:
  void add(const Vec3<double>& direction) {
    const Vec3<double> rest = across(direction);
    if (rest.norm() > kThinnest * direction.norm()) basis_.push_back(rest.normalized());
  }
  /// The part of x that is perpendicular to all of them.
  Vec3<double> across(Vec3<double> x) const {
    for (const Vec3<double>& unit : basis_) x -= x.dot(unit) * unit;
    return x;
  }
  size_t dimension() const { return basis_.size(); }

 private:
  std::vector<Vec3<double>> basis_;
};

/// Whether a body spans less than its count promises in so many dimensions, or has a point twice:
/// three in a line, or more in a plane.
bool is_flat_body(const MovingPatch<double>& hull, size_t dimensions) {
  Span span;
  const Vec3<double>& origin = hull.positions[0];
  for (size_t i = 0; i < hull.positions.size(); ++i) {
    if (i > 0) span.add(hull.positions[i] - origin);
    for (size_t j = 0; j < i; ++j) {
      if (hull.positions[i] == hull.positions[j]) return true;
    }
  }
  return span.dimension() < std::min(dimensions, hull.positions.size() - 1);
}

bool has_flat_face(const Query& query) {
  const auto& faces = query.patches[mesh_side(query)].faces;
  for (size_t f = 0; f < faces.size(); ++f) {
    const Query part = of_face(query, f);
    if (is_flat_body(part.patches[mesh_side(query)], 2)) return true;
  }
  return false;
}

bool is_degenerate(const Case& value) {
  if (is_of_bodies(value.query)) {
    const size_t dimensions = is_in_plane(value.query) ? 2 : 3;
    return is_at_rest(value.query) ||
           std::ranges::any_of(value.query.patches,
                               [&](const MovingPatch<double>& hull) {
                                 return hull.faces.empty() && is_flat_body(hull, dimensions);
                               }) ||
           (has_mesh(value.query) && has_flat_face(value.query));
  }
  const std::optional<Rational> contact = value.truth.contact_by();
  return is_at_rest(value.query) ||
         std::ranges::any_of(value.query.patches, [&](const MovingPatch<double>& patch) {
           return is_flat(patch, 0) || (contact && is_flat(patch, contact->get_d()));
         });
}

/// Whether a face of a one-sided mesh is touched at t = 0, if it is there or not.
bool touches_any_side_at_start(Query query) {
  if (!has_mesh(query)) return false;
  bool& one_sided = query.patches[mesh_side(query)].one_sided;
  if (!std::exchange(one_sided, false)) return false;
  query.t_max = 0;
  return decide(query).truth.collides == true;
}

bool touches_at_start(const Query& query) {
  if (is_of_bodies(query)) return touches_any_side_at_start(query);
  return query.separation == 0 && is_decided_linearly(query) &&
         !check_linear_clearance(query, {Rational(0), true});
}

/// Whether the control points of a vertex and a face, or of two edges, stay in one plane, seen from
/// the first.
bool is_planar(const Query& query) {
  const auto& [first, second] = query.patches;
  if (first.shape.parameter_count() + second.shape.parameter_count() < 2) return false;
  Span span;
  for (const MovingPatch<double>& patch : query.patches) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      span.add(patch.positions[i] - first.positions[0]);
      span.add(rounded_velocity(patch, i) - rounded_velocity(first, 0));
    }
  }
  return span.dimension() < 3;
}

/// Whether the points of a witness hardly move across the two surfaces, but along them.
bool slides_at(const Witness& witness, const Query& query) {
  Vec3<double> velocity{0, 0, 0};
  Span tangents;
  for (const size_t side : {size_t{0}, size_t{1}}) {
    const MovingPatch<double>& patch = query.patches[side];
    const Uv<double> uv = {witness.uv[side][0].get_d(), witness.uv[side][1].get_d()};
    const std::vector<double> weights = bernstein_weights<double>(patch.shape, uv);
    for (size_t i = 0; i < weights.size(); ++i) {
      velocity += (side == 0 ? 1 : -1) * weights[i] * rounded_velocity(patch, i);
      const double t = witness.t.get_d();
      tangents.add(position_at(patch, i, t) - position_at(patch, 0, t));
    }
  }
  return tangents.across(velocity).norm() <= kThinnest * velocity.norm();
}

/// Whether bodies hardly approach along the direction that keeps them apart before their contact.
bool slides_along(const BodyClearance& clearance, const Query& query) {
  Vec3<double> normal;
  for (int k = 0; k < 3; ++k) normal[k] = clearance.normal[k].get_d();
  const Vec3<double> velocity = query.patches[1].velocities[0] - query.patches[0].velocities[0];
  return -normal.dot(velocity) <= kThinnest * normal.norm() * velocity.norm();
}

/// Whether a face of a one-sided mesh is all but along the motion, so that rounding turns it round.
bool slides_along_a_face(const Query& query) {
  const size_t side = mesh_side(query);
  const MovingPatch<double>& mesh = query.patches[side];
  const Vec3<double> velocity = query.patches[1 - side].velocities[0] - mesh.velocities[0];
  return mesh.one_sided && std::ranges::any_of(mesh.faces, [&](const Face& face) {
           const auto corner = [&](size_t i) {
             return mesh.positions[static_cast<size_t>(face[i])];
           };
           const Vec3<double> one = corner(1) - corner(0), two = corner(2) - corner(0);
           const Vec3<double> normal = one.cross(two);
           return std::abs(normal.dot(velocity)) <= kThinnest * normal.norm() * velocity.norm();
         });
}

/// The largest distance of a point of a patch from its first one.
double size_of(const Query& query) {
  double size = 0;
  for (const MovingPatch<double>& patch : query.patches) {
    for (const Vec3<double>& p : patch.positions) {
      size = std::max(size, (p - patch.positions[0]).norm());
    }
  }
  return size;
}

bool slides(const Case& value) {
  if (has_mesh(value.query)) {
    const std::optional<TouchedFace> touched = touched_face(value);
    return slides_along_a_face(value.query) ||
           (touched && slides_along(touched->clearance, touched->query) &&
            !(depth_until(value.query, value.query.t_max) >= kThinnest * size_of(value.query)));
  }
  if (is_of_bodies(value.query)) {
    const auto* apart = clearance_of<BodyClearance>(value.truth);
    return apart != nullptr && value.truth.collides == true && slides_along(*apart, value.query);
  }
  const std::optional<Witness>& witness = value.truth.witness;
  return is_linear_query(value.query) &&
         (is_planar(value.query) || (witness && slides_at(*witness, value.query)));
}

bool is_at_an_end(const Case& value) {
  if (value.query.t_max == 0) return true;
  const std::optional<Rational> contact = value.truth.contact_by();
  if (!contact) return false;
  const double t = contact->get_d(), end = kEndShare * value.query.t_max;
  return t <= end || t >= value.query.t_max - end;
}

}  // namespace

Setting setting_of(const Case& value) {
  if (!is_within_scale(value.query, kOrdinaryScale)) return Setting::kExtreme;
  if (is_degenerate(value)) return Setting::kDegenerate;
  if (touches_at_start(value.query)) return Setting::kTouching;
  if (slides(value)) return Setting::kSliding;
  return is_at_an_end(value) ? Setting::kAtAnEnd : Setting::kOrdinary;
}

bool has_flat_body(const Query& query) {
  return is_of_bodies(query) &&
         std::ranges::any_of(query.patches, [](const MovingPatch<double>& hull) {
           return hull.faces.empty() && hull.positions.size() > 3 && is_flat_body(hull, 3);
         });
}

bool is_shallow(const Case& value) {
  if (value.truth.collides != true || !is_linear_query(value.query)) return false;
  return feature_depth(value, value.query.t_max) < kThinnest * size_of(value.query);
}

}  // namespace ccdfuzz
