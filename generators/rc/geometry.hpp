#pragma once

#include <array>

#include "generators/draw_patch.hpp"
#include "generators/rc/drawn.hpp"
#include "properties/draw_lines.hpp"

namespace ccdfuzz::rc_gen {

/// m·2^e with |m| < 2^bits, lowest ≤ e ≤ highest. Shrinks to fewer bits and to exponents nearer 0.
inline rc::Gen<Dyadic> dyadic(int bits, int lowest, int highest) {
  return drawn([=](Draw& c) {
    const auto exponent = static_cast<long>(c.integer(lowest, highest));
    return c.dyadic(bits, exponent);
  });
}

/// Two doubles at most `reach` floats apart; the first has at most `bits` bits.
inline rc::Gen<std::array<double, 2>> neighbours(int bits, int reach) {
  return drawn([=](Draw& c) {
    const double x = *c.dyadic(bits, -bits / 2).to_double_exactly();
    return std::array{x, c.nudged(x, reach)};
  });
}

/// Control points of a shape on the lattice {−2, …, 2}³, most of them 0 once shrunk.
inline rc::Gen<Points<Dyadic>> lattice_points(const Shape& shape) {
  return drawn([shape](Draw& c) {
    Points<Dyadic> points(static_cast<std::size_t>(shape.control_count()));
    for (Vec3<Dyadic>& p : points) {
      for (int k = 0; k < 3; ++k) p[k] = Dyadic(static_cast<int>(c.integer(-2, 2)));
    }
    return points;
  });
}

/// Lines that are hard to order: concurrent or twins up to a few floats, and so that
/// max f + max g is often about 0; draw_line_pairs.
inline rc::Gen<LinePairs> line_pairs() {
  return drawn(draw_line_pairs);
}

/// Two lines whose slopes differ by at most `reach` floats, and that cross near a time in [0, 4].
inline rc::Gen<std::array<Line<double>, 2>> near_parallel_lines(int reach) {
  return drawn([=](Draw& c) {
    const double slope = std::ldexp(static_cast<double>(c.integer(-63, 63)), -2);
    const double other = c.nudged(slope, reach);
    const double t = std::ldexp(static_cast<double>(c.integer(0, 32)), -3);
    const double height = std::ldexp(static_cast<double>(c.integer(-63, 63)), -2);
    return std::array{Line<double>{slope, c.nudged(height - slope * t, reach)},
                      Line<double>{other, c.nudged(height - other * t, reach)}};
  });
}

/// Three lines by rising slope for which Phi (Eq. 5a) is 0 but for `reach` floats in each
/// intercept; phi and psi (Eqs. 6, 7) are for the first and last of them, at their crossing `t`.
struct NearConcurrent {
  std::array<Line<double>, 3> lines;
  double t = 0;
};
inline rc::Gen<NearConcurrent> near_concurrent_lines(int reach) {
  return drawn([=](Draw& c) {
    NearConcurrent out;
    out.t = std::ldexp(static_cast<double>(c.integer(0, 32)), -3);
    const double height = std::ldexp(static_cast<double>(c.integer(-63, 63)), -2);
    double slope = std::ldexp(static_cast<double>(c.integer(-63, 63)), -2);
    for (Line<double>& line : out.lines) {
      line = {slope, c.nudged(height - slope * out.t, reach)};
      slope += std::ldexp(static_cast<double>(c.integer(1, 15)), -3);
    }
    return out;
  });
}

/// Any shape, and a cell of it at most `depth` splits deep.
struct DeepCell {
  Shape shape;
  Cell cell;
};
inline rc::Gen<DeepCell> deep_cell(int max_degree, int depth) {
  return drawn([=](Draw& c) {
    const Shape shape = draw_shape(c, max_degree);
    return DeepCell{shape, draw_cell(c, shape, depth)};
  });
}

}  // namespace ccdfuzz::rc_gen
