#include "case/horizons.hpp"

#include <cmath>

#include "base/verify.hpp"
#include "case/judge.hpp"

namespace ccdfuzz {

namespace {

/// The end of the horizon. Nothing if it is no finite double or beyond ends, or there is no
/// witness.
std::optional<double> end_at(const Case& known, double factor) {
  CCDFUZZ_VERIFY(factor >= 1);
  if (!known.truth.witness) return std::nullopt;
  const Rational& contact = known.truth.witness->t;
  const Rational end = contact == 0 ? Rational(exact(known.query.t_max) * (exact(factor) - 1))
                                    : Rational(contact * exact(factor));
  const double t_max = round_up(end);
  const bool is_asked = std::isfinite(t_max) && !is_past_motion(known.query, t_max);
  return is_asked ? std::optional(t_max) : std::nullopt;
}

}  // namespace

std::optional<Case> at_horizon(const Case& known, double factor) {
  const std::optional<double> end = end_at(known, factor);
  return end ? std::optional(with_t_max(known, *end)) : std::nullopt;
}

std::optional<CheckedCase> at_horizon(const CheckedCase& known, double factor) {
  const std::optional<double> end = end_at(known.value(), factor);
  return end ? std::optional(known.with_t_max(*end)) : std::nullopt;
}

std::vector<CheckedCase> forms_of(const CheckedCase& known) {
  const Truth& truth = known.value().truth;
  if (truth.collides == false || !truth.witness || is_of_bodies(known.query())) return {known};
  std::vector<CheckedCase> forms;
  for (const double factor : kHorizonFactors) {
    if (auto asked = at_horizon(known, factor)) forms.push_back(std::move(*asked));
  }
  return forms;
}

}  // namespace ccdfuzz
