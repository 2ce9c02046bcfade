#include "eval/horizons.hpp"

#include <cmath>

#include "numeric/verify.hpp"
#include "query/judge.hpp"

namespace ccdfuzz {

std::optional<Case> at_horizon(const Case& known, double factor) {
  CCDFUZZ_VERIFY(factor >= 1);
  if (!known.truth.witness) return std::nullopt;
  const Rational& contact = known.truth.witness->t;
  const Rational end = contact == 0 ? Rational(exact(known.query.t_max) * (exact(factor) - 1))
                                    : Rational(contact * exact(factor));
  const double t_max = round_up(end);
  if (!std::isfinite(t_max)) return std::nullopt;
  return with_t_max(known, t_max);
}

}  // namespace ccdfuzz
