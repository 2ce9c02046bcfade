#include "eval/horizons.hpp"

#include <cmath>

#include "base/verify.hpp"

namespace ccdfuzz {

std::optional<double> horizon_of(const Case& known, double factor) {
  CCDFUZZ_VERIFY(factor >= 1);
  const std::optional<Rational> contact = known.truth.contact_by();
  if (!contact) return std::nullopt;
  const Rational end = *contact == 0 ? Rational(exact(known.query.t_max) * (exact(factor) - 1))
                                     : Rational(*contact * exact(factor));
  const double t_max = round_up(end);
  const bool is_asked = std::isfinite(t_max) && !is_past_motion(known.query, t_max);
  return is_asked ? std::optional(t_max) : std::nullopt;
}

std::vector<CheckedCase> forms_of(const CheckedCase& known) {
  const Truth& truth = known.value().truth;
  if (truth.collides == false || !truth.witness || is_of_bodies(known.query())) return {known};
  std::vector<CheckedCase> forms;
  for (const double factor : kHorizonFactors) {
    if (const auto t_max = horizon_of(known.value(), factor)) {
      forms.push_back(known.with_t_max(*t_max));
    }
  }
  return forms;
}

}  // namespace ccdfuzz
