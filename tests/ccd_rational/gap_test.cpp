#include "ccd/rational/gap.hpp"

#include "ccd_rational/setting.hpp"

namespace ccdfuzz::exact_ccd {
namespace {

void expect_exact_signs(const Setting& s, Gap& gap) {
  s.put(gap);
  const double t = any_window_end(s.query, gap.units());
  const double scaled = gap.scaled(t);
  RC_ASSERT(gap.unscaled(scaled) == t);
  const Extremes extremes = gap.extremes(scaled);
  const std::array<std::vector<ExactLine>, 2> lines = {s.lines(0), s.lines(1)};
  for (size_t below = 0; below < 2; ++below) {
    const Rational exact_value = exact_gap(lines[below], lines[1 - below], exact(t));
    RC_LOG() << "depth " << s.families[0].cell().depth << " t " << to_hex(t) << " below " << below
             << " gap " << exact_value.get_d() << "\n";
    RC_ASSERT(gap.sign(static_cast<int>(below), scaled, extremes) == sgn(exact_value));
  }
}

RC_GTEST_PROP(Gap, SignIsTheExactSignForAllShapesAndScales, ()) {
  Gap gap;
  expect_exact_signs(any_setting(3, 14), gap);
}

RC_GTEST_PROP(Gap, SignIsTheExactSignForHighDegreesAndDeepCells, ()) {
  Gap gap;
  expect_exact_signs(any_setting(kMaxDegree, 40), gap);
}

}  // namespace
}  // namespace ccdfuzz::exact_ccd
