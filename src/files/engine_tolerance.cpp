#include "files/engine_tolerance.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "base/read_double.hpp"
#include "case/judge.hpp"
#include "case/mesh.hpp"
#include "certify/checker/check_turning.hpp"
#include "certify/oracle/body_depth.hpp"
#include "numeric/exact_scalars.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// The angular velocity of a body at time t. For q of cosine and sine it is (c s' − s c')/|q|², for
/// a quaternion the vector of 2 q' q*/|q|². So it is rational where |q| is not.
Vec3<Rational> angular_velocity(const BodyTurn& turn, const Rational& t) {
  if (turn.is_spin()) return {exact(turn.spin[0]), exact(turn.spin[1]), exact(turn.spin[2])};
  std::vector<Rational> q, change;
  Rational square = 0;
  for (size_t i = 0; i < turn.from.size(); ++i) {
    change.push_back(exact(turn.to[i]) - exact(turn.from[i]));
    q.push_back(exact(turn.from[i]) + t * change[i]);
    square += q[i] * q[i];
  }
  if (!turn.is_quaternion()) return {0, 0, Rational(q[0] * change[1] - q[1] * change[0]) / square};
  const Vec3<Rational> v{q[1], q[2], q[3]}, to{change[1], change[2], change[3]};
  return Rational(2 / square) * (q[0] * to - change[0] * v + v.cross(to));
}

/// The velocity of a body's point, which is there at time t.
Vec3<Rational> velocity_at(const MovingPatch<double>& body, const Vec3<Rational>& point,
                           const Rational& t) {
  const Vec3<Rational> velocity = exact(body.velocities[0]);
  if (!body.turn) return velocity;
  const Vec3<Rational> centre = exact(body.turn->centre) + t * velocity;
  return velocity + angular_velocity(*body.turn, t).cross(point - centre);
}

/// What the judge allowed, if the case is a find of the engine. Far from the origin that is more
/// than its usual tolerance.
double allowed_find(const Case& value, const EngineWords& engine, const char* name) {
  const bool is_of_engine = value.expect.contains(fmt::format("plugin:{}", engine.engine));
  return is_of_engine ? said_of(value.origin, name) : 0;
}

/// How late the engine may be by its own tolerance, as a part of a step.
double late_allowed(const Case& value, const EngineWords& engine, double step) {
  return std::max(engine.number("late"), allowed_find(value, engine, kTimeAllowed) / step);
}

/// How late an engine may be about bodies in contact at 0, as a part of the way. Answers are judged
/// by the way or the depth, whichever is within the tolerance for longer (outcome_of).
double allowed_from_start(const Case& value, const EngineWords& engine) {
  const Query& query = value.query;
  const Vec3<double> velocity = query.patches[0].velocities[0] - query.patches[1].velocities[0];
  const double late = late_allowed(value, engine, query.t_max) * query.t_max;
  const double tolerance = depth_allowed(value, engine) + late * velocity.norm();
  // Between these times, of which the first is right and the second may be.
  double right = has_turns(query) ? late : std::min(query.t_max, tolerance / velocity.norm());
  const auto is_right = [&](double until) {
    const std::optional<double> depth = depth_until(query, until, engine.has("plane"));
    return depth && *depth <= tolerance;
  };
  double wrong = is_right(right) ? query.t_max : right;  // no later ones of a deep start
  if (is_right(wrong)) right = wrong;
  for (double t; t = std::midpoint(right, wrong), right < t && t < wrong;) {
    (is_right(t) ? right : wrong) = t;
  }
  return right / step_of_bodies(query, engine);
}

}  // namespace

Vec3<Rational> touched_point(const Case& value, size_t side) {
  const MovingPatch<double>& body = value.query.patches[side];
  const Witness& witness = *value.truth.witness;
  Vec3<Rational> sum{Rational(0), Rational(0), Rational(0)};
  for (size_t i = 0; i < body.positions.size(); ++i) {
    sum += witness.weights[side][i] * exact(body.positions[i]);
  }
  Work work(kMostWork);
  const auto moved = moved_point(body, sum, witness.t, work);
  return moved ? moved->point : sum;
}

double step_of_bodies(const Query& query, const EngineWords& engine) {
  return has_turns(query) && engine.has("turn") ? 1 : query.t_max;
}

double said_of(const Origin& origin, const char* name) {
  const auto said = origin.more.find(name);
  double x = 0;
  if (said != origin.more.end()) {
    read_double(said->second.data(), said->second.data() + said->second.size(), x);
  }
  return x;
}

double depth_allowed(const Case& value, const EngineWords& engine) {
  const char* name = has_mesh(value.query)    ? "mesh depth"
                     : has_spins(value.query) ? "spin depth"
                                              : "depth";
  return std::max(engine.number(engine.has(name) ? name : "depth"),
                  allowed_find(value, engine, kDepthAllowed));
}

double allowed_delay(const Case& value, const EngineWords& engine, double step) {
  if (is_of_bodies(value.query) && *value.truth.contact_by() == 0) {
    return allowed_from_start(value, engine);
  }
  const double depth = depth_allowed(value, engine);
  if (!(depth > 0)) return late_allowed(value, engine, step);
  const auto& patches = value.query.patches;
  const Vec3<double> way =
      (patches[0].velocities[0] - patches[1].velocities[0]) * value.query.t_max;
  double speed = way.norm();
  const std::optional<TouchedFace> face = touched_face(value);
  if (const auto& clear = value.truth.clearance) {
    const auto* apart = face ? &face->clearance : std::get_if<BodyClearance>(&*clear);
    if (apart != nullptr) {
      const Vec3<double> normal(apart->normal[0].get_d(), apart->normal[1].get_d(),
                                apart->normal[2].get_d());
      speed = std::abs(normal.dot(way)) / normal.norm();
    }
    const auto* planes = std::get_if<BodyPlanes>(&*clear);
    if (planes != nullptr && value.truth.witness) {
      const Rational& t = value.truth.witness->t;
      const Vec3<Rational> way_of_points = velocity_at(patches[0], touched_point(value, 0), t) -
                                           velocity_at(patches[1], touched_point(value, 1), t);
      const auto& [x, y, z] = planes->planes.back().normals[1];
      const Vec3<Rational> normal(x, y, z);
      const Rational towards = dot(normal, way_of_points), square = dot(normal, normal);
      speed = Rational(abs(towards)).get_d() / std::sqrt(square.get_d()) *
              step_of_bodies(value.query, engine);
    }
  }
  return speed > depth ? depth / speed : 1;
}

}  // namespace ccdfuzz
