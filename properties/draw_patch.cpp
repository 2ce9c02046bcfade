#include "properties/draw_patch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace ccdfuzz {

Shape draw_shape(ChoiceSource& choices, int max_degree) {
  const std::uint64_t kind = choices.choose(3);
  if (kind == 0) return Shape::point();
  const auto n = static_cast<int>(choices.integer(1, max_degree));
  if (kind == 1) return Shape::curve(n);
  if (kind == 2) return Shape::triangle(n);
  const auto m = static_cast<int>(choices.integer(1, max_degree));
  return Shape::tensor(n, m);
}

Points<Dyadic> draw_points(ChoiceSource& choices, const Shape& shape, int bits, long exponent) {
  Points<Dyadic> points(static_cast<std::size_t>(shape.control_count()));
  for (Vec3<Dyadic>& p : points) {
    for (int k = 0; k < 3; ++k) p[k] = choices.dyadic(bits, exponent);
  }
  return points;
}

Uv<Dyadic> draw_uv(ChoiceSource& choices, const Shape& shape, int bits) {
  const std::int64_t steps = std::int64_t{1} << bits;
  const auto up_to = [&](std::int64_t end) {
    // The ends half of the time: features of lower dimension are where methods break.
    const std::uint64_t where = choices.choose(3);
    if (where == 0) return std::int64_t{0};
    return where == 1 ? end : choices.integer(0, end);
  };
  Uv<Dyadic> uv;
  if (shape.kind == ShapeKind::kPoint) return uv;
  const std::int64_t u = up_to(steps);
  uv[0] = Dyadic(Integer(static_cast<long>(u)), -bits);
  if (shape.kind == ShapeKind::kCurve) return uv;
  const std::int64_t v = up_to(shape.kind == ShapeKind::kTriangle ? steps - u : steps);
  uv[1] = Dyadic(Integer(static_cast<long>(v)), -bits);
  return uv;
}

Cell draw_cell(ChoiceSource& choices, const Shape& shape, int max_depth) {
  Cell cell;
  for (std::int64_t depth = choices.integer(0, max_depth); depth > 0; --depth) {
    const std::int64_t child = choices.integer(0, shape.child_count() - 1);
    cell = cell.child(shape, static_cast<int>(child));
  }
  return cell;
}

namespace {

template <class S, class Text>
std::string list(const Points<S>& points, const Text& text) {
  std::vector<std::string> parts;
  for (const Vec3<S>& p : points) {
    parts.push_back(fmt::format("[{}, {}, {}]", text(p[0]), text(p[1]), text(p[2])));
  }
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

std::string text_of(const Dyadic& x) {
  const auto d = x.to_double_exactly();
  return d ? to_hex(*d) : to_text(x.rational());
}

}  // namespace

Query draw_any_query(ChoiceSource& choices) {
  Query drawn;
  for (MovingPatch<double>& patch : drawn.patches) {
    patch.shape = draw_shape(choices, 2);
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      points->resize(static_cast<std::size_t>(patch.shape.control_count()));
      for (Vec3<double>& p : *points) {
        for (int k = 0; k < 3; ++k) p[k] = choices.finite_double();
      }
    }
  }
  drawn.t_max = std::abs(choices.finite_double());
  return drawn;
}

std::string to_hex_text(const Points<double>& points) {
  return list(points, [](double x) { return to_hex(x); });
}

std::string to_text(const Points<Dyadic>& points) {
  return list(points, text_of);
}

std::string to_text(const Uv<Dyadic>& uv) {
  return fmt::format("({}, {})", text_of(uv[0]), text_of(uv[1]));
}

}  // namespace ccdfuzz
