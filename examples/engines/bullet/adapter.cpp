// Bullet (Debian libbullet-dev): the time of impact of two convex shapes, by
// btContinuousConvexCollision. Points and radii are floats; the margin of a hull is its radius.
// With least-margin=0.04 it is asked only about margins of so much or more, as it recommends.
// With spins=1 it is asked about bodies that spin by up to π/4, too: it turns none by more.
// With mesh=1 it is asked about meshes, too, by what btCollisionWorld::convexSweepTest calls.
// With far=1 numbers are up to 2^16, and end within 2^17. A float is rounded by 2^-8 there.
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <optional>

#include "mesh.hpp"

namespace ccd = adapter::ccd;

struct Bullet {
  explicit Bullet(const std::string& text) {
    adapter::Options options(text);
    least_margin = options.number("least-margin", 0);
    spins = options.number("spins", 0) != 0, meshes = options.number("mesh", 0) != 0;
    far = options.number("far", 0) != 0;
    options.check_all_known();
  }

  ccd::Description describe() const {
    ccd::Description description{"Bullet", ENGINE_VERSION};
    description.claims = CCDFUZZ_TAKES_BODIES | CCDFUZZ_BINARY32 | CCDFUZZ_ORDINARY;  // open ends
    if (spins) description.claims |= CCDFUZZ_TAKES_SPINS | CCDFUZZ_SMALL_SPINS;
    if (meshes) description.claims |= CCDFUZZ_TAKES_MESHES;
    description.within = far ? 16 : 7;
    description.pairs = ccd::body_pairs();
    const bool has_margin = least_margin > 0;  // overlaps of up to 12 points are measured
    description.bodies = {{1, 12, has_margin ? CCDFUZZ_POSITIVE_RADIUS : CCDFUZZ_ANY_RADIUS}};
    description.promise =
#include "promise.json"
        ;
    description.tolerance_kind = CCDFUZZ_TOLERANCE_SPACE;
    // As near it stops (calcTimeOfImpact), and what rounding adds of spins, and far away.
    description.tolerance = 1e-3 + (spins ? spin_rounding : 0) + (far ? far_rounding : 0);
    return description;
  }

  ccd::Answer answer(const ccd::Query& query) const {
    const auto& [a, b] = query.raw.patches;
    for (const ccdfuzz_patch* body : {a, b}) {
      if (body->face_count > 0 || body->radius >= least_margin) continue;
      throw ccd::Refusal("the margin is too small");
    }
    const std::optional<double> share = a->face_count > 0   ? swept(*b, *a, query.t_max())
                                        : b->face_count > 0 ? swept(*a, *b, query.t_max())
                                                            : of_impact(*a, *b, query.t_max());
    if (!share) return {};
    return *share < 0 ? ccd::Answer::miss()
                      : ccd::Answer::hit(adapter::scaled_toi(*share, query.t_max()));
  }

  struct Result : btConvexCast::CastResult {
    void reportFailure(int /*error*/, int /*rounds*/) override { gave_up = true; }
    bool gave_up = false;
  };

  /// The share after which two hulls touch; below 0: they do not. Nothing: Bullet gave up.
  static std::optional<double> of_impact(const ccdfuzz_patch& a, const ccdfuzz_patch& b,
                                         double t_max) {
    const btConvexHullShape first = hull(a), second = hull(b);
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    Result result;
    btContinuousConvexCollision test(&first, &second, &simplex, &depth);
    const bool touches =
        test.calcTimeOfImpact(place(a, 0), place(a, t_max), place(b, 0), place(b, t_max), result);
    return result.gave_up ? std::nullopt : std::optional(touches ? double{result.m_fraction} : -1);
  }

  double least_margin = 0;
  bool spins = false, meshes = false, far = false;
};

CCDFUZZ_PLUGIN(Bullet)
