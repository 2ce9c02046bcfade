// TDIB-CCD, the program of the paper's authors: two patches of one class, with weights or without.
// Options: precision=1e-5 (the width of parameters and of time at which it stops).
#include <solverTD.h>

#include "control_points.hpp"
#include "recBezier.h"
#include "recRatBezier.h"
#include "triBezier.h"
#include "triRatBezier.h"

namespace ccd = adapter::ccd;

struct TdibCcd {
  explicit TdibCcd(const std::string& text) : options(text) {
    precision = options.number("precision", 1e-5);
    options.check_all_known();
  }

  ccd::Description describe() const {
    ccd::Description d{"TDIB-CCD", ENGINE_VERSION};
    d.claims = CCDFUZZ_ORDINARY | CCDFUZZ_TAKES_WEIGHTS;  // neither a contact at 0 nor at the end
    d.pairs = {{{CCDFUZZ_TRIANGLE, CCDFUZZ_TRIANGLE}, {3, 3}},
               {{CCDFUZZ_TENSOR, CCDFUZZ_TENSOR}, {3, 3}}};
    // It gives the middles of two pieces of this width whose boxes meet.
    d.tolerance_kind = CCDFUZZ_TOLERANCE_SPACE_RELATIVE;
    d.tolerance = std::min(1., 32 * precision);
    d.promise =
#include "promise.json"
        ;
    return d;
  }

  ccd::Answer answer(const ccd::Query& query) const {
    const auto& [a, b] = query.raw.patches;
    const bool is_triangle = a->shape == CCDFUZZ_TRIANGLE;
    const bool is_rational = a->weights != nullptr || b->weights != nullptr;
    const std::uint32_t n = a->degree_u, m = is_triangle ? 0 : n;
    if (a->degree_v == m && b->degree_u == n && b->degree_v == m) {
      const std::uint32_t kind = n + (is_triangle ? 10 : 0) + (is_rational ? 100 : 0);
      if (kind == 1) return asked<RecLinearBezier, RecParamBound>(query);
      if (kind == 2) return asked<RecQuadBezier, RecParamBound>(query);
      if (kind == 3) return asked<RecCubicBezier, RecParamBound>(query);
      if (kind == 11) return asked<TriLinearBezier, TriParamBound>(query);
      if (kind == 12) return asked<TriQuadBezier, TriParamBound>(query);
      if (kind == 13) return asked<TriCubicBezier, TriParamBound>(query);
      if (kind == 102) return asked<RecQuadRatBezier, RecParamBound>(query);
      if (kind == 103) return asked<RecCubicRatBezier, RecParamBound>(query);
      if (kind == 112) return asked<TriQuadRatBezier, TriParamBound>(query);
      if (kind == 113) return asked<TriCubicRatBezier, TriParamBound>(query);
    }
    throw ccd::Refusal("these are not two patches of one of its classes");
  }

  template <class Patch, class Bound>
  ccd::Answer asked(const ccd::Query& query) const {
    std::array<Patch, 2> p, v;
    for (int side = 0; side < 2; ++side) {
      const ccdfuzz_patch& raw = *query.raw.patches[side];
      fill(p[side], raw, raw.positions);
      fill(v[side], raw, raw.velocities);
    }
    Array2d uv[2];
    const double toi = SolverTD<Patch, Patch, Bound, Bound>::solveCCD(
        p[0], v[0], p[1], v[1], uv[0], uv[1], BoundingBoxType::OBB, precision, query.t_max());
    ccd::Answer answer = toi == -1 ? ccd::Answer::miss() : ccd::Answer::hit(toi);
    for (int side = 0; side < 2; ++side) std::copy_n(uv[side].data(), 2, answer.uv[side]);
    return answer;
  }

  adapter::Options options;
  double precision = 1e-5;
};

CCDFUZZ_PLUGIN(TdibCcd)
