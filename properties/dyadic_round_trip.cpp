#include "properties/dyadic_round_trip.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace ccdfuzz {

Check dyadic_round_trip(double x, double y) {
  const auto failure = [&](const char* what) {
    return Check::fails(fmt::format("{} for x = {}, y = {}", what, to_hex(x), to_hex(y)));
  };
  const Dyadic dx = Dyadic::exact(x), dy = Dyadic::exact(y);
  const Rational rx = exact(x), ry = exact(y);
  if (dx.to_double_exactly() != std::optional(x)) return failure("Dyadic does not give x back");
  if (to_double_exactly(rx) != std::optional(x)) return failure("Rational does not give x back");
  if (dx.rational() != rx) return failure("Dyadic and Rational differ on x");
  if (Dyadic::from(rx) != std::optional(dx)) return failure("Dyadic::from(Rational) differs on x");
  if (Rational(rx + ry) != (dx + dy).rational()) return failure("x + y differs");
  if (Rational(rx - ry) != (dx - dy).rational()) return failure("x - y differs");
  if (Rational(rx * ry) != (dx * dy).rational()) return failure("x * y differs");
  if ((rx < ry) != (dx < dy)) return failure("x < y differs");
  if ((dx + dy) - dy != dx) return failure("(x + y) - y is not x");
  return Check::holds();
}

Check check_dyadic_round_trip(Draw& choices) {
  const double x = choices.finite_double();
  // Near each other half of the time, where sums cancel.
  if (!choices.coin()) return dyadic_round_trip(x, choices.finite_double());
  const double mirror = choices.coin() ? -x : x;
  const double y = choices.nudged(mirror, 4);
  return dyadic_round_trip(x, y);
}

}  // namespace ccdfuzz
