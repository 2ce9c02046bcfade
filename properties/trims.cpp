#include <algorithm>
#include <cmath>

#include "bezier/exact_patch.hpp"
#include "bezier/orientation.hpp"
#include "bezier/trim_region.hpp"
#include "certify/checker/check_trim.hpp"
#include "generators/draw_patch.hpp"
#include "generators/draw_trim.hpp"
#include "properties/draw_trimmed.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Uv<double> draw_place(Draw& d, const Shape& shape) {
  const Uv<Dyadic> uv = draw_uv(d, shape, 4);
  return {*uv[0].to_double_exactly(), *uv[1].to_double_exactly()};
}

/// In the box about a cell, if that is in the domain, or anywhere.
Uv<double> draw_place_about(Draw& d, const Shape& shape, const Cell& cell) {
  const Uv<double> anywhere = draw_place(d, shape);
  if (d.coin()) return anywhere;
  Uv<double> place;
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const auto along = [&](const Uv<double>& corner) { return corner[k]; };
    const auto corners = cell.corners(shape);
    const auto [lo, hi] = std::ranges::minmax(corners, {}, along);
    place[k] = lo[k] + d.integer(0, 8) / 8.0 * (hi[k] - lo[k]);
  }
  return shape.contains(exact_place(place)) ? place : anywhere;
}

/// Points that are nearly on a line, or anywhere, down to subnormal coordinates.
void check_trim_orientation(Draw& d) {
  std::array<Uv<double>, 3> p;
  const bool is_small = d.choose(3) == 3;
  for (Uv<double>& at : p) {
    for (double& x : at) {
      x = std::abs(*d.dyadic(53, -53).to_double_exactly());
      if (is_small) x = std::ldexp(x, -static_cast<int>(d.choose(1100)));
    }
  }
  if (d.coin()) {
    const double share = std::ldexp(static_cast<double>(d.choose(8)), -3);
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      p[2][k] = d.nudged(p[0][k] + share * (p[1][k] - p[0][k]), 1);
    }
  }
  const auto way = [&](std::size_t to, std::size_t k) {
    return Rational(exact(p[to][k]) - exact(p[0][k]));
  };
  const Rational area = way(1, 0) * way(2, 1) - way(1, 1) * way(2, 0);
  show(d, "points", p);
  CLAIM(orientation(p[0], p[1], p[2]) == sgn(area));
}

/// What spoils loops is refused, naming the loop; what a draw gives is not. Which shapes loops may
/// have, trim_loops.cpp claims.
void check_trim_valid(Draw& d) {
  Query query = draw_any_query(d);
  MovingPatch<double>& patch = query.patches[d.choose(1)];
  suppose(patch.shape.parameter_count() == 2);
  patch.trim = draw_trim(d, patch.shape, draw_place(d, patch.shape));
  CLAIM(is_valid(query));
  auto& loop = patch.trim[d.below(patch.trim.size())];
  switch (d.choose(2)) {
    case 0:
      loop.resize(2);
      break;
    case 1:
      loop[d.below(loop.size())][d.choose(1)] =
          d.pick(std::array{-0x1p-1074, 1 + 0x1p-52, std::nan(""), HUGE_VAL});
      break;
    default:
      patch.shape = Shape::curve(1);
      patch.positions.resize(2);
      patch.velocities.resize(2);
      patch.weights.clear();
      patch.ends.clear();
  }
  show(d, "query", query);
  const auto fault = fault_of(query);
  CLAIM(fault && fault->where.find(".trim") != std::string::npos);
}

/// Two codes that share nothing place each cell alike. A cell outside has no point of the region. A
/// cell inside has no other.
void check_trim_cells(Draw& d) {
  MovingPatch<double> patch{draw_surface(d, 1), {}, {}};
  const Cell cell = show(d, "cell", draw_cell(d, patch.shape, 6));
  const Uv<double> p = draw_place_about(d, patch.shape, cell);
  patch.trim = draw_trim(d, patch.shape, p);
  TrimRegion domain;
  domain.assign(patch);
  const TrimRegion::Cover cover = domain.cover(cell);
  show(d, "shape", patch.shape);
  show(d, "trim", patch.trim);
  show(d, "cover", static_cast<int>(cover));
  const auto corners = cell.corners(patch.shape);
  std::vector<Uv<Rational>> polygon;
  if (patch.shape.kind == ShapeKind::kTriangle) {
    for (const Uv<double>& c : corners) polygon.push_back(exact_place(c));
  } else {
    const auto [lo, hi] = std::array{exact_place(corners[0]), exact_place(corners[1])};
    polygon = {lo, {hi[0], lo[1]}, hi, {lo[0], hi[1]}};
  }
  Work work(kMostWork);
  const Region region = region_of(patch.trim, polygon, work);
  CLAIM((cover == TrimRegion::Cover::kInside) == (region == Region::kInside));
  CLAIM((cover == TrimRegion::Cover::kOutside) == (region == Region::kOutside));
  const auto claim_point = [&](const Uv<Rational>& at) {
    const bool is_in = is_in_region(patch.trim, at);
    CLAIM(!(is_in && cover == TrimRegion::Cover::kOutside));
    CLAIM(!(!is_in && cover == TrimRegion::Cover::kInside));
  };
  Uv<Rational> mean = {0, 0};
  for (const Uv<Rational>& at : polygon) {
    claim_point(at);
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      mean[k] += at[k] / static_cast<long>(polygon.size());
    }
  }
  claim_point(mean);
  if (contains(cell, patch.shape, exact_place(p))) claim_point(exact_place(p));
  for (const auto& loop : patch.trim) {
    for (const Uv<double>& vertex : loop) {
      // A vertex in the closed cell is of the region, so the cell is not outside.
      CLAIM(!contains(cell, patch.shape, exact_place(vertex)) ||
            cover == TrimRegion::Cover::kCrossed);
      CLAIM(domain.contains(vertex));
    }
  }
  CLAIM(domain.contains(p) == is_in_region(patch.trim, exact_place(p)));
}

}  // namespace

std::vector<Property> trims_claims() {
  return {
      {"trims.valid", "Loops that no patch may have are refused, naming the field",
       "src/bezier/trim.hpp", check_trim_valid},
      {"trims.orientation", "On which side of a line a point is, is exact for all doubles",
       "src/bezier/orientation.hpp", check_trim_orientation},
      {"trims.cells", "A cell is outside, or inside, iff all of it is, to methods and checker",
       "src/bezier/trim_region.hpp", check_trim_cells},
  };
}

}  // namespace ccdfuzz
