#include "properties/draw_grazing.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>

namespace ccdfuzz {

namespace {

/// Less than 1 in magnitude, of 52 bits.
double full_number(Draw& choices) {
  return *choices.dyadic(52, -52).to_double_exactly();
}

Vec3<double> full_vector(Draw& choices) {
  return {full_number(choices), full_number(choices), full_number(choices)};
}

}  // namespace

Query draw_grazing(Draw& choices) {
  Query query;
  auto& [a, b] = query.patches;
  const bool edges = choices.coin(), turns = choices.coin();
  a.shape = edges ? Shape::curve(1) : Shape::triangle(1);
  b.shape = edges ? Shape::curve(1) : Shape::point();
  // Positions at the time of the crossing first.
  for (MovingPatch<double>& patch : query.patches) {
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      patch.positions.push_back(full_vector(choices));
      patch.velocities.push_back(turns || i == 0 ? full_vector(choices) : patch.velocities[0]);
    }
  }
  const Vec3<double> edge = a.positions[1] - a.positions[0];
  const Vec3<double> other =
      edges ? b.positions[1] - b.positions[0] : a.positions[2] - a.positions[0];
  int k = 0;  // the largest component of the normal
  edge.cross(other).cwiseAbs().maxCoeff(&k);
  // In that component the product of the edge and the motion is 0.
  Vec3<double> motion = full_number(choices) * edge;
  motion[k] += full_number(choices);
  const double share = choices.pick(std::array{0.0, 0.25, 0.5, 1.0});
  const auto on_edge = [share](const Points<double>& of) -> Vec3<double> {
    return (1 - share) * of[0] + share * of[1];
  };
  const Vec3<double> shift = on_edge(a.positions) - b.positions[0];
  const Vec3<double> change = on_edge(a.velocities) + motion - b.velocities[0];
  for (Vec3<double>& p : b.positions) p += shift;
  for (Vec3<double>& v : b.velocities) v += change;

  const double t = choices.pick(std::array{0.5, 0.75, 1.0, 1 - 0x1p-20});
  for (MovingPatch<double>& patch : query.patches) {
    for (std::size_t i = 0; i < patch.positions.size(); ++i) {
      patch.positions[i] -= t * patch.velocities[i];
    }
  }
  query.t_max = 1;
  return query;
}

}  // namespace ccdfuzz
