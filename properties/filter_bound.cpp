#include <algorithm>

#include "generators/draw_patch.hpp"
#include "properties/error_bound.hpp"
#include "properties/exact_gaps.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// The sum over position and velocity of the largest |2^scale·(x − x of control point 0 of patch
/// 1)|: the M of Gap's filter.
Dyadic magnitude_of(const Query& query, int length_shift, int horizon) {
  Dyadic position, velocity;
  const auto& [a, b] = query.patches;
  const MovingPatch<Dyadic> first = exact_patch<Dyadic>(a);
  const Vec3<Dyadic> drift = a.has_ends() == b.has_ends() ? first.velocities[0] : Vec3<Dyadic>();
  for (const MovingPatch<Dyadic>& moving : {first, exact_patch<Dyadic>(b)}) {
    for (std::size_t i = 0; i < moving.positions.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        position = std::max(position, abs(moving.positions[i][k] - first.positions[0][k]));
        velocity = std::max(velocity, abs(moving.velocities[i][k] - drift[k]));
      }
    }
  }
  return position.scaled(length_shift) + velocity.scaled(length_shift + horizon);
}

/// The patches are plain, have ends, or are rational.
void check_filter(Draw& d) {
  Query query = draw_extreme_query(d);
  const std::uint64_t kind = d.choose(2);
  if (kind == 1) query = supposed(with_drawn_ends(query, d));
  for (MovingPatch<double>& patch : query.patches) {
    if (kind == 2) patch.weights = draw_patch_weights(d, patch.positions.size());
  }
  const GapSetting setting = draw_gap_setting(d, query, 4);
  exact_ccd::Gap gap;
  setting.put(gap);
  const double t = show(d, "t", d.coin() ? *abs(d.dyadic(30, -30)).to_double_exactly() : 1);
  const exact_ccd::Extremes at = gap.extremes(t);
  const Dyadic error = Dyadic::exact(gap.error());
  show(d, "error", gap.error());
  show(d, "gaps", std::array{at.gap(0), at.gap(1)});
  const int horizon = gap.units().horizon;
  const auto gaps = setting.gaps(exact(t) * power_of_two(horizon));
  for (int below = 0; below < 2; ++below) {
    const Rational& known = gaps[static_cast<std::size_t>(below)];
    const Rational off = exact(at.gap(below)) - known * power_of_two(gap.length_shift());
    CLAIM(abs(off) <= error.rational());
  }
  // 2·gamma_(K + 7)·M + 140·eta a unit of |l|_1, as derived above Gap::begin. A blossom step from
  // scratch takes three roundings for a triangle and two else, and the split one for each argument.
  // Numerator and weight of a rational patch have these, and two more are of product and quotient.
  int most = 0;
  for (const MovingPatch<double>& patch : query.patches) {
    const int each = patch.shape.kind == ShapeKind::kTriangle ? 4 : 3;
    const int of_cell = each * (patch.shape.n + patch.shape.m);
    most = std::max(most, patch.is_rational() ? 2 * of_cell + 2 : of_cell);
  }
  // gamma_k = ku/(1 − ku) ≤ ku(1 + 2ku).
  const int of_ends = has_ends(query) ? 2 : 0;
  const Dyadic ku = Dyadic(most + 7 + of_ends) * half_ulp();
  const Dyadic gamma = ku * (Dyadic(1) + ku.scaled(1));
  const Dyadic per_norm = gamma.scaled(1) * magnitude_of(query, gap.length_shift(), horizon) +
                          Dyadic(140) * least_double().scaled(is_rational(query) ? 60 : 0);
  const Dyadic norm(Integer(static_cast<long>(setting.axis.norm1())), 0);
  CLAIM(per_norm * norm <= error);
}

}  // namespace

std::vector<Property> filter_bound_claims() {
  return {
      {"tdibm-rational.error_bound",
       "Gaps in doubles are off by the filter's error at most, which is no less than what was "
       "derived, also of patches with ends or weights",
       "src/ccd/rational/gap.cpp", check_filter},
  };
}

}  // namespace ccdfuzz
