#include "generators/shaped/families.hpp"

#include <utility>

#include "bezier/restrict.hpp"
#include "generators/shaped/heights.hpp"

namespace ccdfuzz {

namespace {

// Heights are multiples of 2^-9 times the squares of parameters that are quarters.
constexpr long kExtendedHeightUnit = -9;
constexpr int kQuarters = 2;  // bits of parameters

Dyadic quarters(std::int64_t n) {
  return {Integer(static_cast<long>(n)), -kQuarters};
}

/// The patch above the plane with its contact at `at`, and zero heights as said.
ContactSide side_over(const Shape& shape, const Uv<Dyadic>& at, ZeroSet zeros, Draw& draw) {
  ContactSide side{shape, at, flat_net(shape, false, draw), {}};
  raise(side.points, heights_over(shape, at, zeros, kExtendedHeightUnit, draw));
  return side;
}

/// Pairs of edges that have the same degree, one of each shape.
std::vector<std::array<ShapeEdge, 2>> edges_alike(const ShapePair& shapes) {
  std::vector<std::array<ShapeEdge, 2>> pairs;
  for (const ShapeEdge& a : edges_of(shapes[0])) {
    for (const ShapeEdge& b : edges_of(shapes[1])) {
      if (a.degree(shapes[0]) == b.degree(shapes[1])) pairs.push_back({a, b});
    }
  }
  return pairs;
}

/// Where two points of a patch are and what heights are 0 there and positive elsewhere, as far as
/// its degrees allow.
struct TwoPoints {
  std::array<Uv<Dyadic>, 2> at;
  std::vector<Dyadic> heights;
};

TwoPoints two_corners(const Shape& shape, Draw& draw) {
  const std::vector<Uv<Dyadic>> corners = corners_of(shape);
  const size_t first = draw.below(corners.size());
  const size_t second = (first + 1 + draw.below(corners.size() - 1)) % corners.size();
  TwoPoints two{{corners[first], corners[second]}, {}};
  for_each_control(shape, [&](int i, int j) {
    const bool zero = bears(shape, two.at[0], i, j) || bears(shape, two.at[1], i, j);
    two.heights.emplace_back(zero ? 0 : draw.integer(1, 64));
  });
  return two;
}

/// Points on two edges: (v − v0)² + k·u(1 − u) on a square, (u + v − s)² + k·uv on a triangle.
TwoPoints on_two_edges(const Shape& shape, Draw& draw) {
  const Dyadic s = quarters(draw.integer(1, 3)), zero, one(1);
  const Dyadic k(draw.integer(1, 4));
  const bool triangle = shape.kind == ShapeKind::kTriangle;
  TwoPoints two{{{{zero, s}, {triangle ? s : one, triangle ? zero : s}}}, {}};
  const Linear u = {zero, one, zero}, v = {zero, zero, one};
  const Linear along = {-s, triangle ? one : zero, one};
  const bool square_in_v = (triangle ? shape.n : shape.m) >= 2, in_u = shape.n >= 2;
  LowPolynomial h;
  if (square_in_v) h = product(along, along);
  if (in_u) {
    const Linear rest = {one, -one, zero};
    const LowPolynomial off = product(triangle ? v : rest, u);
    for (size_t c = 0; c < h.size(); ++c) h[c] += k * off[c];
  }
  two.heights = coefficients_on(shape, h);
  return two;
}

/// Inner points (1/4, v0) and (3/4, v0): 4((u − 1/4)(u − 3/4))² + (v − v0)². The first has these
/// Bernstein coefficients of degree 4, times 3·64.
TwoPoints two_inner_points(const Shape& shape, Draw& draw) {
  constexpr std::array<int, 5> kTwoDips = {27, -45, 59, -45, 27};
  const Dyadic v0 = quarters(draw.integer(1, 3)), zero, one(1);
  TwoPoints two{{{{quarters(1), v0}, {quarters(3), v0}}}, {}};
  const Linear along = {-v0, zero, one};
  two.heights = coefficients_on(shape, product(along, along));
  for_each_control(shape, [&](int i, int j) {
    two.heights[static_cast<size_t>(shape.index(i, j))] +=
        Dyadic(kTwoDips[static_cast<size_t>(i)], -6);
  });
  return two;
}

/// They lie on a face, an edge and a corner.
constexpr std::array kTwoPoints = {two_inner_points, on_two_edges, two_corners};

/// A straight patch below the plane, in it at all of the feature, with its points y[0] and y[1] at
/// p[0] and p[1]. y differ in u alone, by a power of two, and p by a multiple of odd_denominator.
ContactSide plate_under(Feature feature, const Shape& shape, const std::array<Uv<Dyadic>, 2>& y,
                        const std::array<Vec3<Dyadic>, 2>& p, Draw& draw) {
  const Dyadic odd = odd_denominator(shape), one(1);
  Vec3<Dyadic> across = flat_net(Shape::curve(1), false, draw)[1];
  for (int k = 0; k < 2; ++k) across[k] *= odd;
  const Dyadic step = y[1][0] - y[0][0];  // 2^-k
  const std::vector<Dyadic> along =
      coefficients_on(shape, {-y[0][0], one, Dyadic(), Dyadic(), Dyadic(), Dyadic()});
  std::vector<Dyadic> sideways(along.size());
  if (shape.parameter_count() == 2) {
    sideways = coefficients_on(shape, {-y[0][1], Dyadic(), one, Dyadic(), Dyadic(), Dyadic()});
  }
  // Those coefficients are times odd already.
  const Rational share = 1 / Rational(odd.rational() * step.rational());
  ContactSide side{shape, y[0], {}, {}};
  for (size_t i = 0; i < along.size(); ++i) {
    Vec3<Dyadic> point = p[0];
    for (int k = 0; k < 2; ++k) {
      const Rational exact_share = Rational(p[1][k].rational() - p[0][k].rational()) * share;
      const auto factor = Dyadic::from(exact_share);
      CCDFUZZ_VERIFY(factor);
      point[k] += *factor * along[i];
      point[k] += across[k] * sideways[i];
    }
    side.points.push_back(point);
  }
  if (feature != Feature::kFace) {
    const ShapeEdge edge{{0, 0}, {1, 0}};
    raise(side.points,
          heights_over(shape, edge.at(Dyadic(1, -1)), ZeroSet::kLine, kExtendedHeightUnit, draw));
  }
  turn_over(side);
  return side;
}

/// A random part of a surface, its corners on the grid of quarters, as restrict_to takes it. A
/// triangle has the corners where the part's (u, v) are (0, 0), (1, 0) and (0, 1); a square those
/// where they are (0, 0) and (1, 1).
std::array<Uv<Dyadic>, 3> random_part(const Shape& shape, Draw& draw) {
  const bool triangle = shape.kind == ShapeKind::kTriangle;
  using Corner = std::array<std::int64_t, 2>;
  const auto c = draw.until(
      [&] {
        std::array<Corner, 3> drawn{};
        for (Corner& corner : drawn) {
          corner[0] = draw.integer(0, 4);
          corner[1] = draw.integer(0, triangle ? 4 - corner[0] : 4);
        }
        return drawn;
      },
      [&](const std::array<Corner, 3>& p) {
        const std::int64_t u = p[1][0] - p[0][0], v = p[1][1] - p[0][1];
        return (triangle ? u * (p[2][1] - p[0][1]) - v * (p[2][0] - p[0][0]) : u * v) != 0;
      });
  std::array<Uv<Dyadic>, 3> corners;
  for (size_t k = 0; k < 3; ++k) corners[k] = {quarters(c[k][0]), quarters(c[k][1])};
  return corners;
}

bool can_have_two_points(Feature feature, const Shape& shape) {
  switch (feature) {
    case Feature::kFace:
      return shape.kind == ShapeKind::kTensor && shape.n == 4 && shape.m >= 2;
    case Feature::kEdge:
      return shape.parameter_count() == 2;
    case Feature::kCorner:
      return shape.kind != ShapeKind::kPoint;
  }
  return false;
}

PlacedScene placed(ContactScene scene, Draw& draw) {
  return {std::move(scene), random_placement(draw)};
}

}  // namespace

bool have_edges_alike(ContactClass, const ShapePair& shapes) {
  return !edges_alike(shapes).empty();
}

/// An edge of one patch is a part of an edge of the other, or all of it.
PlacedScene touching_along_edges(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  const std::array<Feature, 2> features = features_of(contact);
  const auto pairs = edges_alike(shapes);
  const std::array<ShapeEdge, 2> edges = pairs[draw.below(pairs.size())];
  // The edge of `part` is that of the other patch from `from` to `to`; there the contact is at s.
  const bool corner_on_edge = features[0] != features[1];
  const size_t part = corner_on_edge ? 0 : draw.below(2);
  Dyadic from = quarters(draw.integer(0, 2)), to = quarters(draw.integer(3, 4));
  Dyadic s = quarters(draw.integer(1, 3));
  if (features[0] == Feature::kCorner) s = Dyadic();
  if (corner_on_edge) from = quarters(draw.integer(1, 2));
  if (features[1] == Feature::kCorner) from = Dyadic();
  if (draw.coin()) {  // the other way round
    std::swap(from, to);
    s = Dyadic(1) - s;
  }
  const std::array<Dyadic, 2> on_edge = {s, from + s * (to - from)};
  ContactScene scene;
  for (size_t side = 0; side < 2; ++side) {
    const Dyadic middle(1, -1);
    scene.sides[side] = side_over(shapes[side], edges[side].at(middle), ZeroSet::kLine, draw);
    scene.sides[side].at = edges[side].at(on_edge[side == part ? 0 : 1]);
  }
  const std::vector<size_t> to_places = edges[part].controls(shapes[part]);
  const std::vector<size_t> from_places = edges[1 - part].controls(shapes[1 - part]);
  Points<Dyadic> whole;
  for (const size_t place : from_places) whole.push_back(scene.sides[1 - part].points[place]);
  Points<Dyadic> cut(whole.size());
  restrict_to<Dyadic>(Shape::curve(static_cast<int>(whole.size()) - 1), whole,
                      {{{from, Dyadic()}, {to, Dyadic()}, {}}}, cut);
  for (size_t i = 0; i < cut.size(); ++i) scene.sides[part].points[to_places[i]] = cut[i];
  turn_over(scene.sides[1]);
  let_approach(scene, draw);
  return placed(std::move(scene), draw);
}

bool have_a_line(ContactClass, const ShapePair& shapes) {
  return shapes[0].kind != ShapeKind::kPoint;
}

/// One patch touches the flat other one along a line of its parameters.
PlacedScene touching_along_a_line(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  const std::array<Feature, 2> features = features_of(contact);
  const size_t flat = features[0] == Feature::kFace ? draw.below(2) : 1;
  ContactScene scene;
  for (size_t s = 0; s < 2; ++s) {
    const Uv<Dyadic> at = point_on(features[s], shapes[s], kQuarters, draw);
    scene.sides[s] = side_over(shapes[s], at, s == flat ? ZeroSet::kAll : ZeroSet::kLine, draw);
    centre(scene.sides[s]);
  }
  turn_over(scene.sides[1]);
  let_approach(scene, draw);
  return placed(std::move(scene), draw);
}

bool have_two_points(ContactClass contact, const ShapePair& shapes) {
  return can_have_two_points(features_of(contact)[0], shapes[0]) &&
         shapes[1].kind != ShapeKind::kPoint;
}

/// One patch touches the straight other one in two points, or more.
PlacedScene touching_at_points(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  const std::array<Feature, 2> features = features_of(contact);
  const TwoPoints upper = kTwoPoints[static_cast<size_t>(features[0])](shapes[0], draw);
  ContactScene scene;
  ContactSide& side = scene.sides[0];
  side = {shapes[0], upper.at[0], flat_net(shapes[0], false, draw), {}};
  const Dyadic odd = odd_denominator(shapes[1]);
  for (Vec3<Dyadic>& p : side.points) p *= odd;
  std::vector<Dyadic> heights = upper.heights;
  for (Dyadic& h : heights) h = h.scaled(kExtendedHeightUnit);
  raise(side.points, heights);
  std::array<Vec3<Dyadic>, 2> p;
  for (size_t k = 0; k < 2; ++k) p[k] = evaluate<Dyadic>(shapes[0], side.points, upper.at[k]);
  const Dyadic zero, one(1);
  std::array<Uv<Dyadic>, 2> y = {{{zero, zero}, {one, zero}}};
  if (features[1] == Feature::kEdge) y = {{{quarters(1), zero}, {quarters(3), zero}}};
  if (features[1] == Feature::kFace) y = {{{quarters(1), quarters(1)}, {quarters(2), quarters(1)}}};
  scene.sides[1] = plate_under(features[1], shapes[1], y, p, draw);
  let_approach(scene, draw);
  scene.separated = contact != ContactClass::kFF;
  return placed(std::move(scene), draw);
}

bool are_equal_surfaces(ContactClass, const ShapePair& shapes) {
  return shapes[0].parameter_count() == 2 && shapes[0] == shapes[1];
}

/// One patch is a part of the other: both flat, or curved and moved by one velocity.
PlacedScene touching_over_an_area(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  const std::array<Feature, 2> features = features_of(contact);
  const Shape& shape = shapes[0];
  const bool curved = draw.coin();
  ContactScene scene;
  ContactSide &part = scene.sides[0], &whole = scene.sides[1];
  whole = {shape, {}, flat_net(shape, false, draw), {}};
  if (curved) {
    for (Vec3<Dyadic>& p : whole.points) p[2] = draw.lattice(8, -6);
  }
  const auto corners = draw.until(
      [&] {
        const std::array<Uv<Dyadic>, 3> drawn = random_part(shape, draw);
        part.at = point_on(features[0], shape, kQuarters, draw);
        return drawn;
      },
      [&](const auto& drawn) {
        whole.at = on_whole(shape, drawn, part.at);
        return feature_at(shape, whole.at) == features[1];
      });
  part.shape = shape;
  part.points.resize(whole.points.size());
  restrict_to<Dyadic>(shape, whole.points, corners, part.points);
  let_approach(scene, draw);
  if (curved) {
    for (ContactSide& side : scene.sides) side.rates.assign(side.rates.size(), side.rates[0]);
    scene.separated = false;
  }
  return placed(std::move(scene), draw);
}

}  // namespace ccdfuzz
