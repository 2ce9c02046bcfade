#include "properties/draw_trimmed.hpp"

#include "generators/draw_contact.hpp"
#include "generators/draw_trim.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

Case draw_trimmed(Draw& choices) {
  Case known = supposed(draw_contact(choices, {-2, 2, 3}));
  const std::uint64_t sides = 1 + choices.choose(2);
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = known.query.patches[s];
    if ((sides >> s & 1) == 0 || patch.shape.parameter_count() != 2) continue;
    const Uv<Rational>& at = known.truth.witness->uv[s];
    patch.trim = draw_trim(choices, patch.shape, {round_down(at[0]), round_down(at[1])});
  }
  suppose(is_trimmed(known.query));
  return known;
}

Case draw_trimmed_contact(Draw& choices) {
  Case known = draw_trimmed(choices);
  suppose(is_in_regions(known));
  return known;
}

bool is_in_region(const Trim& trim, const Uv<Rational>& at) {
  bool odd = false;
  for (const auto& loop : trim) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& from = loop[i];
      const auto& to = loop[(i + 1) % loop.size()];
      const Rational u0 = exact(from[0]) - at[0], v0 = exact(from[1]) - at[1];
      const Rational u1 = exact(to[0]) - at[0], v1 = exact(to[1]) - at[1];
      const Rational area = u0 * v1 - u1 * v0;
      if (area == 0 && u0 * u1 <= 0 && v0 * v1 <= 0) return true;
      if ((u0 <= 0) == (u1 <= 0)) continue;
      // The edge is at v = area / (u0 − u1) where u is that of the point.
      odd ^= area / (u0 - u1) > 0;
    }
  }
  return odd;
}

bool is_in_regions(const Case& known) {
  for (std::size_t s = 0; s < 2; ++s) {
    const Trim& trim = known.query.patches[s].trim;
    if (!trim.empty() && !is_in_region(trim, known.truth.witness->uv[s])) return false;
  }
  return true;
}

}  // namespace ccdfuzz
