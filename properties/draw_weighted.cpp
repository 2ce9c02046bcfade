#include "properties/draw_weighted.hpp"

#include "bezier/exact_patch.hpp"
#include "fuzz/mutator/moves.hpp"
#include "generators/draw_patch.hpp"
#include "generators/weighted.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

Contact draw_pulled(Draw& choices) {
  Contact q = supposed(contact_of(supposed(draw_contact(choices, {-2, 2, 3}))));
  const std::uint64_t sides = 1 + choices.choose(2);
  for (std::size_t s = 0; s < 2; ++s) {
    if ((sides >> s & 1) == 0 || q.query.patches[s].positions.size() == 1) continue;
    suppose(pull_by_weights(choices, q, s, 3));
    draw_free_weights(choices, q, s);
  }
  return q;
}

Contact draw_balanced(Draw& choices) {
  std::array<Shape, 2> shapes;
  std::array<Uv<Dyadic>, 2> uv;
  for (std::size_t s = 0; s < 2; ++s) {
    shapes[s] = draw_shape(choices, 3);
    uv[s] = draw_uv(choices, shapes[s], 3);
  }
  return supposed(draw_balanced_contact(choices, shapes, uv));
}

}  // namespace

Contact draw_weighted_contact(Draw& choices) {
  Contact q = choices.coin() ? draw_balanced(choices) : draw_pulled(choices);
  suppose(is_rational(q.query) && is_valid(q.query));
  for (std::uint64_t left = choices.choose(2); left > 0; --left) {
    if (Contact next = q; change_coordinates(next, choices)) q = std::move(next);
  }
  return q;
}

FirstContact draw_weighted_first_contact(Draw& choices, Query* plain) {
  FirstContact drawn = draw_first_contact(choices);
  if (plain != nullptr) *plain = drawn.query;
  Contact q = supposed(contact_of(drawn));
  for (std::size_t s = 0; s < 2; ++s) {
    suppose(pull_by_weights(choices, q, s, 1));
    const auto [least, most] =
        std::minmax_element(q.query.patches[s].weights.begin(), q.query.patches[s].weights.end());
    // Control points go away by at most 2; derivatives grow by the square of the ratio.
    drawn.early *= 2 * (*most / *least) * (*most / *least);
  }
  drawn.query = q.query;
  return drawn;
}

}  // namespace ccdfuzz
