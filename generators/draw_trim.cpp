#include "generators/draw_trim.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "bezier/trim.hpp"

namespace ccdfuzz {

using Loop = std::vector<Uv<double>>;

namespace {

Uv<double> draw_vertex(Draw& choices, const Shape& shape) {
  const int bits = 2 + static_cast<int>(choices.choose(4));
  const std::uint64_t most = std::uint64_t{1} << bits;
  const std::uint64_t u = choices.choose(most);
  const std::uint64_t v = choices.choose(shape.kind == ShapeKind::kTriangle ? most - u : most);
  return {std::ldexp(static_cast<double>(u), -bits), std::ldexp(static_cast<double>(v), -bits)};
}

Loop draw_loop(Draw& choices, const Shape& shape, const Uv<double>& p) {
  switch (choices.choose(3)) {
    case 0:
      return loop_about(shape, p, static_cast<int>(choices.choose(10)));
    case 1: {
      const auto halvings = static_cast<int>(choices.choose(4));
      return loop_about(shape, draw_vertex(choices, shape), halvings);
    }
    case 2:
      return draw_loop_through(choices, shape, p, choices.coin());
    default: {
      Loop loop(3 + choices.choose(2));
      for (Uv<double>& vertex : loop) vertex = draw_vertex(choices, shape);
      return loop;
    }
  }
}

}  // namespace

Loop draw_loop_through(Draw& choices, const Shape& shape, const Uv<double>& p, bool is_vertex) {
  const double du = choices.integer(-4, 4), dv = choices.integer(-4, 4);
  const int unit = -3 - static_cast<int>(choices.choose(8));
  const double to = std::ldexp(1 + static_cast<double>(choices.choose(3)), unit);
  const double from = is_vertex ? 0 : std::ldexp(1 + static_cast<double>(choices.choose(3)), unit);
  return {{p[0] - from * du, p[1] - from * dv},
          {p[0] + to * du, p[1] + to * dv},
          draw_vertex(choices, shape)};
}

Loop loop_about(const Shape& shape, const Uv<double>& p, int halvings) {
  Loop loop = shape.kind == ShapeKind::kTriangle ? Loop{{0, 0}, {1, 0}, {0, 1}}
                                                 : Loop{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (Uv<double>& vertex : loop) {
    for (const size_t k : {size_t{0}, size_t{1}}) {
      vertex[k] = p[k] + std::ldexp(vertex[k] - p[k], -halvings);
    }
  }
  return loop;
}

void turn_round(Trim& trim, Draw& choices) {
  for (Loop& loop : trim) {
    if (choices.coin()) std::reverse(loop.begin(), std::prev(loop.end()));
  }
}

Trim draw_trim(Draw& choices, const Shape& shape, const Uv<double>& p) {
  return choices.until(
      [&] {
        Trim trim;
        // Most often all of the domain comes first, in which the others are holes.
        if (choices.choose(2) != 0) trim.push_back(loop_about(shape, p, 0));
        for (std::uint64_t left = 1 + choices.choose(2); left > 0; --left) {
          trim.push_back(draw_loop(choices, shape, p));
        }
        for (std::uint64_t left = choices.choose(2); left > 0; --left) {
          Loop& loop = trim[choices.below(trim.size())];
          double& x = loop[choices.below(loop.size())][choices.choose(1)];
          x = choices.nudged(x, 1);
        }
        turn_round(trim, choices);
        return trim;
      },
      [&](const Trim& trim) { return !fault_of(trim, shape); });
}

}  // namespace ccdfuzz
