#include "generators/shaped/features.hpp"

#include <algorithm>

namespace ccdfuzz {

Uv<Dyadic> ShapeEdge::at(const Dyadic& s) const {
  return {Dyadic(origin[0]) + s * Dyadic(direction[0]),
          Dyadic(origin[1]) + s * Dyadic(direction[1])};
}

std::optional<Dyadic> ShapeEdge::parameter_of(const Uv<Dyadic>& uv) const {
  const size_t k = direction[0] != 0 ? 0 : 1;  // where the direction is 1
  const Dyadic s = uv[k] - Dyadic(origin[k]);
  if (s < Dyadic(0) || s > Dyadic(1) || at(s) != uv) return std::nullopt;
  return s;
}

std::vector<size_t> ShapeEdge::controls(const Shape& shape) const {
  std::vector<size_t> places;
  const int in_v = degree_in_v(shape);
  for (int k = 0; k <= degree(shape); ++k) {
    const int i = origin[0] * shape.n + k * direction[0];
    const int j = origin[1] * in_v + k * direction[1];
    places.push_back(static_cast<size_t>(shape.index(i, j)));
  }
  return places;
}

std::vector<ShapeEdge> edges_of(const Shape& shape) {
  const ShapeEdge along_u{{0, 0}, {1, 0}}, along_v{{0, 0}, {0, 1}};
  switch (shape.kind) {
    case ShapeKind::kHull:
      refuse_hull();
    case ShapeKind::kPoint:
      return {};
    case ShapeKind::kCurve:
      return {along_u};
    case ShapeKind::kTriangle:
      return {along_u, along_v, {{0, 1}, {1, -1}}};
    case ShapeKind::kTensor:
      return {along_u, along_v, {{0, 1}, {1, 0}}, {{1, 0}, {0, 1}}};
  }
  return {};
}

std::vector<ShapeEdge> edges_through(const Shape& shape, const Uv<Dyadic>& uv) {
  std::vector<ShapeEdge> edges = edges_of(shape);
  std::erase_if(edges, [&](const ShapeEdge& e) { return !e.parameter_of(uv); });
  return edges;
}

std::vector<Uv<Dyadic>> corners_of(const Shape& shape) {
  if (shape.kind == ShapeKind::kHull) refuse_hull();
  const Dyadic zero, one(1);
  const std::array<Uv<Dyadic>, 4> all = {{{zero, zero}, {one, zero}, {zero, one}, {one, one}}};
  const int count = 1 + shape.parameter_count() + (shape.kind == ShapeKind::kTensor ? 1 : 0);
  return {all.begin(), all.begin() + count};
}

bool has_feature(const Shape& shape, Feature feature) {
  switch (feature) {
    case Feature::kFace:
      return shape.parameter_count() == 2;
    case Feature::kEdge:
      return shape.parameter_count() > 0;
    case Feature::kCorner:
      return true;
  }
  return false;
}

Feature feature_at(const Shape& shape, const Uv<Dyadic>& uv) {
  const auto& [u, v] = uv;
  const Dyadic zero, one(1);
  int bounds = 0;
  switch (shape.kind) {
    case ShapeKind::kHull:
      refuse_hull();
    case ShapeKind::kPoint:
      return Feature::kCorner;
    case ShapeKind::kCurve:
      return u == zero || u == one ? Feature::kCorner : Feature::kEdge;
    case ShapeKind::kTriangle:
      bounds = (u == zero) + (v == zero) + (u + v == one);
      break;
    case ShapeKind::kTensor:
      bounds = (u == zero || u == one) + (v == zero || v == one);
      break;
  }
  return bounds == 0 ? Feature::kFace : bounds == 1 ? Feature::kEdge : Feature::kCorner;
}

bool bears(const Shape& shape, const Uv<Dyadic>& uv, int i, int j) {
  const auto& [u, v] = uv;
  const Dyadic zero, one(1);
  if ((u == zero && i != 0) || (v == zero && j != 0)) return false;
  if (shape.kind == ShapeKind::kTriangle) return u + v != one || i + j == shape.n;
  return (u != one || i == shape.n) && (v != one || j == shape.m);
}

Uv<Dyadic> on_whole(const Shape& shape, const std::array<Uv<Dyadic>, 3>& part,
                    const Uv<Dyadic>& uv) {
  const bool triangle = shape.kind == ShapeKind::kTriangle;
  Uv<Dyadic> at = part[0];
  for (size_t k = 0; k < 2; ++k) {
    const Dyadic to_first = part[1][k] - part[0][k], to_second = part[2][k] - part[0][k];
    at[k] += triangle ? uv[0] * to_first + uv[1] * to_second : uv[k] * to_first;
  }
  return at;
}

Shape random_shape(Feature feature, Draw& draw) {
  if (feature == Feature::kCorner && draw.below(8) == 0) return Shape::point();
  if (feature != Feature::kFace && draw.below(4) == 0) return Shape::curve(draw.integer(1, 5));
  if (draw.coin()) return Shape::triangle(draw.integer(1, 5));
  const int n = draw.integer(1, 4);
  return Shape::tensor(n, draw.integer(1, 4));
}

Uv<Dyadic> point_on(Feature feature, const Shape& shape, int bits, Draw& draw) {
  const auto inner = [&] { return Dyadic(Integer(draw.integer(1, (1L << bits) - 1)), -bits); };
  if (feature == Feature::kCorner) {
    const std::vector<Uv<Dyadic>> corners = corners_of(shape);
    return corners[draw.below(corners.size())];
  }
  if (feature == Feature::kEdge) {
    const std::vector<ShapeEdge> edges = edges_of(shape);
    return edges[draw.below(edges.size())].at(inner());
  }
  if (shape.kind == ShapeKind::kTriangle) {
    // The first of (u, v, w) that is drawn, and then the others, at least one step each.
    const int steps = 1 << bits;
    std::array<int, 3> x{};
    const size_t first = draw.below(3), second = (first + 1) % 3;
    x[first] = draw.integer(1, steps - 2);
    x[second] = draw.integer(1, steps - x[first] - 1);
    x[(first + 2) % 3] = steps - x[first] - x[second];
    return {Dyadic(x[0], -bits), Dyadic(x[1], -bits)};
  }
  const Dyadic u = inner();
  return {u, inner()};
}

int parameter_bits(const Shape& shape) {
  constexpr int kMostWeightBits = 24, kMost = 12;
  return std::min(kMost, kMostWeightBits / std::max(1, shape.n + shape.m));
}

}  // namespace ccdfuzz
