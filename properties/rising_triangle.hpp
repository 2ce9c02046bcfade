#pragma once

#include "case/case.hpp"

namespace ccdfuzz {

/// A triangle that rises to meet the tip of a second one. First contact is at t = 1/2, at the inner
/// point u = v = 1/4 of the one and the corner u = v = 0 of the other.
inline Case rising_triangle() {
  Case c;
  const Vec3<double> up = {0, 0, 1}, still = {0, 0, 0};
  c.query.patches[0] = {Shape::triangle(1), {{-1, -1, 0}, {-1, 3, 0}, {3, -1, 0}}, {up, up, up}};
  c.query.patches[1] = {
      Shape::triangle(1), {{0, 0, 0.5}, {1, 0, 1}, {0, 1, 1}}, {still, still, still}};
  c.truth.collides = true;
  c.truth.witness =
      Witness{Rational(1, 2), {Uv<Rational>{Rational(1, 4), Rational(1, 4)}, Uv<Rational>{0, 0}}};
  c.truth.clear_until = Rational(1, 2);
  return c;
}

/// The same contact by a box: the corner stays, a point of the rising triangle and the time vary.
inline ContactBox rising_box() {
  return {{0.25, 0.25, 0, 0, 0.5},
          {0, 0},
          {0, 1, 4},
          {0x1p-10, 0x1p-10, 0x1p-10},
          {{{0.25, 0, 0}, {0, 0.25, 0}, {0, 0, 1}}}};
}

/// The plane of the rising triangle: separates until they touch.
inline MovingPlane rising_plane() {
  return {Rational(1, 2), {Rational(0), Rational(0), Rational(-1)}, Rational(-1, 2)};
}

}  // namespace ccdfuzz
