// FCL (Debian libfcl-dev): continuousCollide of balls and tetrahedra by conservative advancement.
// Some turn, by InterpMotion, whose angular velocity is constant. With overlap=1 some overlap at 0.
// With far=1 numbers are up to 2^40, and none turns.
#include <fcl/narrowphase/continuous_collision.h>

#include "shapes.hpp"

namespace ccd = adapter::ccd;

struct FclBodies {
  explicit FclBodies(const std::string& text) {
    adapter::Options options(text);
    overlap = options.number("overlap", 0) != 0;
    far = options.number("far", 0) != 0;
    options.check_all_known();
  }

  ccd::Description describe() const {
    ccd::Description description{"FCL", ENGINE_VERSION};
    description.claims = CCDFUZZ_TAKES_BODIES | CCDFUZZ_ORDINARY;  // open ends
    if (!far) description.claims |= CCDFUZZ_TAKES_SPINS | CCDFUZZ_SHORT_SPINS;
    description.within = far ? 40 : 7;
    description.pairs = ccd::body_pairs();
    description.bodies = {{1, 1, CCDFUZZ_POSITIVE_RADIUS}, {4, 4, CCDFUZZ_NO_RADIUS}};
    description.promise =
#include "promise.json"
        ;
    if (overlap) {
      description.claims |= CCDFUZZ_INITIAL_OVERLAP | CCDFUZZ_CONTACT_AT_ZERO;
      description.promise += "; "
#include "overlap.json"
          ;
    }
    description.tolerance_kind = far ? CCDFUZZ_TOLERANCE_SPACE : CCDFUZZ_TOLERANCE_TIME_RELATIVE;
    description.tolerance = far ? 0x1p40 : kTimeError;  // far off each answer says its own
    return description;
  }

  ccd::Answer answer(const ccd::Query& query) const {
    const auto& [a, b] = query.raw.patches;
    const auto first = shape(*a), second = shape(*b);
    const Motion way = motion(*a, query.t_max()), other = motion(*b, query.t_max());
    const fcl::ContinuousCollisionRequestd request(
        10, kTimeError, fcl::CCDM_LINEAR, fcl::GST_LIBCCD, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide(first.get(), &way, second.get(), &other, request, result);
    ccd::Answer answer = ccd::Answer::miss();
    if (result.is_collide) {
      answer = ccd::Answer::hit(adapter::scaled_toi(result.time_of_contact, query.t_max()));
    }
    if (!far) return answer;
    const Vector velocity = Vector(a->velocities[0]) - Vector(b->velocities[0]);
    answer.tolerance = kTimeError * query.t_max() * velocity.norm() + adapter::lost_length(query);
    return answer;
  }

  static constexpr double kTimeError = 1e-4;  // toc_err of a request, by default
  bool overlap = false, far = false;
};

CCDFUZZ_PLUGIN(FclBodies)
