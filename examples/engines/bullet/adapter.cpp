// Bullet 3.24 (Debian libbullet-dev): the time of impact of two convex shapes, by
// btContinuousConvexCollision. Points and radii are floats; the margin of a hull is its radius.
// With least-margin=0.04 it is asked only about margins of so much or more, as it recommends.
// With spins=1 it is asked about bodies that spin by up to π/4, too: it turns none by more.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "../../plugins/adapter.hpp"

namespace ccd = adapter::ccd;

struct Bullet {
  explicit Bullet(const std::string& text) : options(text) {
    least_margin = options.number("least-margin", 0);
    spins = options.number("spins", 0) != 0;
    options.check_all_known();
  }

  ccd::Description describe() const {
    ccd::Description description{"Bullet", std::to_string(btGetVersion())};
    description.claims = CCDFUZZ_TAKES_BODIES | CCDFUZZ_BINARY32 | CCDFUZZ_ORDINARY;  // open ends
    description.within = 7;
    description.pairs = {{{CCDFUZZ_HULL, CCDFUZZ_HULL}, {81, 81}}};
    const bool has_margin = least_margin > 0;  // overlaps of up to 12 points are measured
    description.bodies = {{1, 12, has_margin ? CCDFUZZ_POSITIVE_RADIUS : CCDFUZZ_ANY_RADIUS}};
    if (spins) description.claims |= CCDFUZZ_TAKES_SPINS;
    description.promise =
        "calculates the angular and linear time of impact of two convex shapes: "
        "https://github.com/bulletphysics/"
        "bullet3/blob/3.24/src/BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h";
    description.tolerance_kind = CCDFUZZ_TOLERANCE_SPACE;
    description.tolerance = 1e-3;              // as near it stops (calcTimeOfImpact)
    if (spins) description.tolerance += 1e-4;  // what rounding 443 from a centre adds
    return description;
  }

  static btVector3 vector(const double (&x)[3]) {
    btVector3 v(0, 0, 0);
    for (int k = 0; k < 3; ++k) v[k] = adapter::as_float(x[k]);
    return v;
  }

  /// The point that a body turns about.
  static btVector3 middle(const ccdfuzz_patch& body) {
    return body.turn_count > 0 ? vector(body.turn_centre) : btVector3(0, 0, 0);
  }

  static btQuaternion turned(const ccdfuzz_patch& body, double t_max) {
    btScalar q[4];
    const auto exact = adapter::spun(body, t_max, SIMD_PI / 4);
    for (int i = 0; i < 4; ++i) q[i] = static_cast<btScalar>(exact[i]);
    return {q[1], q[2], q[3], q[0]};
  }

  std::unique_ptr<btConvexShape> shape(const ccdfuzz_patch& body) const {
    if (body.radius < least_margin) throw adapter::Refusal("the margin is too small");
    auto hull = std::make_unique<btConvexHullShape>();
    for (std::uint64_t i = 0; i < body.count; ++i) {
      hull->addPoint(vector(body.positions[i]) - middle(body), false);
    }
    hull->recalcLocalAabb();
    hull->setMargin(adapter::as_float(body.radius));
    return hull;
  }

  ccd::Answer answer(const ccd::Query& query) const {
    std::unique_ptr<btConvexShape> shapes[2];
    btTransform from[2], to[2];
    try {
      for (int side = 0; side < 2; ++side) {
        const ccdfuzz_patch& body = *query.raw.patches[side];
        shapes[side] = shape(body);
        double way[3];
        for (int k = 0; k < 3; ++k) way[k] = body.velocities[0][k] * query.t_max();
        from[side] = btTransform(btQuaternion::getIdentity(), middle(body));
        to[side] = btTransform(turned(body, query.t_max()), middle(body) + vector(way));
      }
    } catch (const adapter::Refusal& refusal) {
      return adapter::refused(refusal);
    }
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btContinuousConvexCollision cast(shapes[0].get(), shapes[1].get(), &simplex, &depth);
    btConvexCast::CastResult result;
    const bool touches = cast.calcTimeOfImpact(from[0], to[0], from[1], to[1], result);
    return touches ? ccd::Answer::hit(adapter::scaled_toi(double{result.m_fraction}, query.t_max()))
                   : ccd::Answer::miss();
  }

  adapter::Options options;
  double least_margin = 0;
  bool spins = false;
};

CCDFUZZ_PLUGIN(Bullet)
