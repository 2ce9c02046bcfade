#include "generators/draw_patch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bezier/exact_patch.hpp"
#include "files/case_json.hpp"

namespace ccdfuzz {

Shape draw_shape(Draw& choices, int max_degree) {
  const std::uint64_t kind = choices.choose(3);
  if (kind == 0) return Shape::point();
  const int n = choices.integer(1, max_degree);
  if (kind == 1) return Shape::curve(n);
  if (kind == 2) return Shape::triangle(n);
  const int m = choices.integer(1, max_degree);
  return Shape::tensor(n, m);
}

Shape draw_surface(Draw& choices, int max_degree) {
  const int n = choices.integer(1, max_degree);
  if (!choices.coin()) return Shape::triangle(n);
  return Shape::tensor(n, choices.integer(1, max_degree));
}

Vec3<double> draw_integers(Draw& choices, std::int64_t most) {
  Vec3<double> v;
  for (double& x : v) x = static_cast<double>(choices.integer(-most, most));
  return v;
}

Points<Dyadic> draw_points(Draw& choices, const Shape& shape, int bits, long exponent) {
  Points<Dyadic> points(static_cast<std::size_t>(shape.control_count()));
  for (Vec3<Dyadic>& p : points) {
    for (int k = 0; k < 3; ++k) p[k] = choices.dyadic(bits, exponent);
  }
  return points;
}

Uv<Dyadic> draw_uv(Draw& choices, const Shape& shape, int bits) {
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

Uv<Dyadic> draw_fine_uv(Draw& choices, const Shape& shape, int bits) {
  const auto below_one = [&] {
    Integer digits = 0;
    std::uint64_t reversed = choices.below(std::uint64_t{1} << bits);
    for (int i = 0; i < bits; ++i, reversed >>= 1) digits = 2 * digits + (reversed & 1);
    return Dyadic(digits, -bits);
  };
  Uv<Dyadic> uv;
  if (shape.kind == ShapeKind::kPoint) return uv;
  uv[0] = below_one();
  if (shape.kind == ShapeKind::kCurve) return uv;
  uv[1] = below_one();
  if (shape.kind == ShapeKind::kTriangle && uv[0] + uv[1] > 1) uv = {1 - uv[0], 1 - uv[1]};
  return uv;
}

Cell draw_cell_at(Draw& choices, const Shape& shape, std::int64_t depth) {
  Cell cell;
  const auto last = static_cast<std::uint64_t>(shape.child_count() - 1);
  for (; depth > 0; --depth) cell = cell.child(shape, static_cast<int>(choices.choose(last)));
  return cell;
}

Cell draw_cell(Draw& choices, const Shape& shape, int max_depth) {
  return draw_cell_at(choices, shape, choices.integer(0, max_depth));
}

namespace {

/// Any finite double, and as often one of the largest: with the exponent 1022 or 1023.
double draw_base(Draw& choices) {
  if (!choices.coin()) return choices.finite_double();
  constexpr int kBits = 4;  // of the 53
  const double digits = choices.integer(1 << (kBits - 1), (1 << kBits) - 1);
  const double x = std::ldexp(digits, 1024 - kBits - static_cast<int>(choices.choose(1)));
  return choices.coin() ? -x : x;
}

/// The exponent of a lattice of 8-bit coordinates, as often one of the lowest.
long draw_unit(Draw& choices) {
  constexpr int kLowest = -1074, kHighest = 1024 - 8;
  const bool low = choices.coin();
  return choices.integer(kLowest, low ? kLowest + 8 : kHighest);
}

/// Coordinates as they are hardest to bring to one magnitude. Along each axis they are all alike,
/// all alike but for a few floats, on a lattice of any unit, or any at all.
void draw_coordinates(Draw& choices, bool all_alike, std::array<Points<double>*, 2> points) {
  enum Style : std::uint64_t { kAlike, kLattice, kNudged, kAny };
  for (int k = 0; k < 3; ++k) {
    const std::uint64_t style = all_alike ? kAlike : choices.choose(kAny);
    const double base = draw_base(choices);
    const long unit = draw_unit(choices);
    for (Points<double>* side : points) {
      for (Vec3<double>& p : *side) {
        p[k] = base;
        if (style == kLattice) p[k] = *choices.dyadic(8, unit).to_double_exactly();
        if (style == kNudged) p[k] = choices.nudged(base, 20);
        if (style == kAny) p[k] = choices.finite_double();
        if (!std::isfinite(p[k])) p[k] = base;
      }
    }
  }
}

}  // namespace

Query draw_small_query(Draw& choices, int max_degree) {
  Query query;
  for (MovingPatch<double>& patch : query.patches) {
    patch.shape = max_degree == 0 ? Shape::point() : draw_shape(choices, max_degree);
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      patch.positions.push_back(draw_integers(choices, 8));
      patch.velocities.push_back(draw_integers(choices, 15) / 8);
    }
  }
  return query;
}

Query draw_query(Draw& choices, int max_degree, const std::function<double(Draw&)>& draw_number) {
  Query drawn;
  for (MovingPatch<double>& patch : drawn.patches) {
    patch.shape = draw_shape(choices, max_degree);
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      points->resize(static_cast<std::size_t>(patch.shape.control_count()));
    }
    for_each_coordinate(patch, [&](double& x) { x = draw_number(choices); });
  }
  return drawn;
}

Query draw_any_query(Draw& choices) {
  Query drawn = draw_query(choices, 2, [](Draw& d) { return d.finite_double(); });
  drawn.t_max = std::abs(choices.finite_double());
  return drawn;
}

Query draw_extreme_query(Draw& choices) {
  Query drawn = draw_query(choices, 2, [](Draw&) { return 0.0; });
  auto& [a, b] = drawn.patches;
  // Where the ones are all alike, the scale is that of the others alone.
  const std::uint64_t alike = choices.choose(3);
  draw_coordinates(choices, alike == 1, {&a.positions, &b.positions});
  draw_coordinates(choices, alike == 2, {&a.velocities, &b.velocities});
  drawn.t_max = choices.coin() ? std::abs(choices.finite_double()) : 1;
  return drawn;
}

std::optional<Query> with_drawn_ends(Query query, Draw& choices) {
  query.t_max = std::min(query.t_max, 1.0);
  const auto sides = static_cast<unsigned>(choices.integer(1, 3));
  for (std::size_t s = 0; s < 2; ++s) {
    if ((sides >> s & 1) != 0) give_rounded_ends(query.patches[s]);
  }
  if (!is_valid(query)) return std::nullopt;
  return query;
}

std::vector<double> draw_patch_weights(Draw& choices, std::size_t count) {
  enum Kind : std::uint64_t { kPowers, kIntegers, kManyBits, kFar, kCircle, kRoundedCircle };
  const std::uint64_t kind = choices.choose(kRoundedCircle);
  std::vector<double> weights(count, 1);
  for (std::size_t i = 0; i < count; ++i) {
    double& w = weights[i];
    if (kind == kPowers) w = std::ldexp(1.0, choices.integer(-3, 3));
    if (kind == kIntegers) w = choices.integer(1, 9);
    if (kind == kManyBits) w = 1 + std::ldexp(static_cast<double>(choices.choose(1 << 30)), -31);
    if (kind == kCircle) w = i % 3 == 2 ? 2 : 1;
    if (kind == kRoundedCircle) w = i % 3 == 1 ? std::sqrt(0.5) : 1;
  }
  if (kind == kFar) weights[choices.below(count)] = choices.coin() ? 0x1p40 : 0x1p-40;
  return weights;
}

std::string to_text(const Query& query) {
  Case about;
  about.query = query;
  return to_json(about);
}

std::string to_text(const Cell& cell) {
  return fmt::format("i = {}, j = {}, depth = {}{}", cell.i, cell.j, cell.depth,
                     cell.inverted ? ", inverted" : "");
}

}  // namespace ccdfuzz
