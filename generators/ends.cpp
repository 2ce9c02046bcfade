#include "generators/ends.hpp"

#include <cmath>

#include "base/double_parts.hpp"
#include "generators/draw_patch.hpp"
#include "generators/shaped/families.hpp"
#include "generators/shaped/shaped_case.hpp"

namespace ccdfuzz {

std::optional<Query> parted(const Query& query, Draw& draw, std::array<Similarity, 2>* changes) {
  const int size = parts_of(query.patches[0].positions[0].cwiseAbs().maxCoeff()).top();
  std::optional<Query> out = query;
  const auto change_by = [&](const Similarity& change, std::size_t i) {
    const std::optional<Query> moved = similar(*out, change);
    if (!moved) return false;
    out = moved;
    if (changes != nullptr) (*changes)[i] = change;
    return true;
  };
  constexpr int kStep = 4, kLeast = 2;
  const Vec3<double> little = draw_integers(draw, 3);
  int exponent = -draw.integer(30, 45);
  const auto by_little = [&] {
    const Vec3<double> shift = std::ldexp(1, size + exponent) * little;
    return change_by({shift, -shift}, 0);
  };
  while (!by_little()) {
    exponent += kStep;
    if (exponent > -kLeast) return std::nullopt;
  }
  const Vec3<double> much = draw_integers(draw, 3);
  exponent = draw.integer(5, 30);
  while (!change_by({{0, 0, 0}, std::ldexp(1, size + exponent) * much}, 1)) {
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
  std::array<Similarity, 2> changes;
  const std::optional<Query> query = parted(made.query, draw, &changes);
  if (!query || with_velocities(*query)) return tl::unexpected(Discard::kRoundTrip);
  for (const Similarity& change : changes) made = *similar(made, change);
  return as_asked(std::move(made), options);
}

}  // namespace ccdfuzz
