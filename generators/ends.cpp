#include "generators/ends.hpp"

#include <cmath>

#include "base/double_parts.hpp"
#include "generators/draw_patch.hpp"
#include "generators/shaped/families.hpp"
#include "generators/shaped/shaped_case.hpp"

namespace ccdfuzz {

std::optional<Case> parted(const Case& value, Draw& draw) {
  const int size = parts_of(value.query.patches[0].positions[0].cwiseAbs().maxCoeff()).top();
  std::optional<Case> out = value;
  const auto change_by = [&](const Similarity& change) {
    std::optional<Case> moved = similar(*out, change);
    if (!moved) return false;
    out = std::move(moved);
    return true;
  };
  constexpr int kStep = 4, kLeast = 2;
  const Vec3<double> little = draw_integers(draw, 3);
  int exponent = -draw.integer(30, 45);
  const auto by_little = [&] {
    const Vec3<double> shift = std::ldexp(1, size + exponent) * little;
    return change_by({shift, -shift});
  };
  while (!by_little()) {
    exponent += kStep;
    if (exponent > -kLeast) return std::nullopt;
  }
  const Vec3<double> much = draw_integers(draw, 3);
  exponent = draw.integer(5, 30);
  while (!change_by({{0, 0, 0}, std::ldexp(1, size + exponent) * much})) {
    exponent -= kStep;
    if (exponent < kLeast) return std::nullopt;
  }
  return out;
}

/// A regular or interior-time case whose patches have ends. Some difference of an end to the start
/// is no double.
Attempted ends_case(const GeneratorOptions& options, Draw& draw) {
  const Family family = draw.coin() ? Family::kInteriorTime : Family::kRegular;
  CCDFUZZ_TRY(Case made, plain_case(family, options, draw));
  const Query plain = made.query;
  for (MovingPatch<double>& patch : made.query.patches) give_rounded_ends(patch);
  if (with_velocities(made.query) != plain) return tl::unexpected(Discard::kRoundTrip);
  std::optional<Case> moved = parted(made, draw);
  if (!moved || with_velocities(moved->query)) return tl::unexpected(Discard::kRoundTrip);
  return as_asked(*std::move(moved), options);
}

}  // namespace ccdfuzz
