#pragma once

#include "base/verify.hpp"
#include "bezier/blossom.hpp"
#include "case/case.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

inline constexpr std::array kSomeShapes = {
    Shape::point(),     Shape::curve(1),     Shape::curve(3),    Shape::triangle(1),
    Shape::triangle(2), Shape::tensor(2, 1), Shape::tensor(3, 3)};

struct Planted {
  Query query;
  Witness witness;
};

/// Random patches of the two shapes, the second translated so that both meet exactly at a dyadic
/// point of each and t = 1/2; t_max = 1. The contact need not be the first.
inline Planted plant_contact(Draw& random, const Shape& first, const Shape& second) {
  const std::array<Shape, 2> shapes = {first, second};
  const Dyadic t(1, -1);
  std::array<MovingPatch<Dyadic>, 2> patches;
  std::array<Uv<Dyadic>, 2> uv;
  std::array<Vec3<Dyadic>, 2> at_contact;
  for (int side = 0; side < 2; ++side) {
    const Shape& shape = shapes[side];
    patches[side].shape = shape;
    for (int i = 0; i < shape.control_count(); ++i) {
      patches[side].positions.push_back(random.vector(10, -8));
      patches[side].velocities.push_back(random.vector(10, -8));
    }
    const long u = random.integer(0, 4);
    const long v = random.integer(0, shape.kind == ShapeKind::kTriangle ? 4 - u : 4);
    if (shape.parameter_count() > 0) uv[side][0] = Dyadic(Integer(u), -2);
    if (shape.parameter_count() > 1) uv[side][1] = Dyadic(Integer(v), -2);
    at_contact[side] = evaluate(patches[side], uv[side], t);
  }
  Planted planted;
  planted.witness.t = t.rational();
  planted.query.t_max = 1;
  for (int side = 0; side < 2; ++side) {
    MovingPatch<double>& out = planted.query.patches[side];
    out.shape = shapes[side];
    for (size_t i = 0; i < patches[side].positions.size(); ++i) {
      Vec3<double> p, v;
      for (int k = 0; k < 3; ++k) {
        Dyadic x = patches[side].positions[i][k];
        if (side == 1) x += at_contact[0][k] - at_contact[1][k];
        p[k] = x.to_double_exactly().value();
        v[k] = patches[side].velocities[i][k].to_double_exactly().value();
      }
      out.positions.push_back(p);
      out.velocities.push_back(v);
    }
    for (int k = 0; k < 2; ++k) planted.witness.uv[side][k] = uv[side][k].rational();
  }
  return planted;
}

}  // namespace ccdfuzz
