#include "properties/dyadic_round_trip.hpp"

#include "properties/show.hpp"

namespace ccdfuzz {

void claim_dyadic_round_trip(double x, double y) {
  const Dyadic dx = Dyadic::exact(x), dy = Dyadic::exact(y);
  const Rational rx = exact(x), ry = exact(y);
  CLAIM(dx.to_double_exactly() == std::optional(x));
  CLAIM(to_double_exactly(rx) == std::optional(x));
  CLAIM(dx.rational() == rx);
  CLAIM(Dyadic::from(rx) == std::optional(dx));
  CLAIM(Rational(rx + ry) == (dx + dy).rational());
  CLAIM(Rational(rx - ry) == (dx - dy).rational());
  CLAIM(Rational(rx * ry) == (dx * dy).rational());
  CLAIM((rx < ry) == (dx < dy));
  CLAIM((dx + dy) - dy == dx);
}

std::vector<Property> dyadic_round_trip_claims() {
  return {{"dyadic.round_trip",
           "A double goes to exact numbers and back without loss, and both exact number types "
           "agree on every sum, difference, product and order",
           "Section 5.4", [](Draw& d) {
             const double x = d.finite_double();
             // Near each other half of the time, where sums cancel.
             const bool is_near = d.coin();
             const double y = is_near ? d.nudged(d.coin() ? -x : x, 4) : d.finite_double();
             show(d, "x", x);
             show(d, "y", y);
             claim_dyadic_round_trip(x, y);
           }}};
}

}  // namespace ccdfuzz
