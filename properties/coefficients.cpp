#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "ccd/projection.hpp"
#include "ccd/sub_patches.hpp"
#include "generators/draw_patch.hpp"
#include "numeric/exact_scalars.hpp"
#include "numeric/products.hpp"
#include "properties/error_bound.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

constexpr int kDoubleBits = 53;

/// A multiple of 2^-53 in [0, most·2^-53].
double draw_fraction(Draw& choices, std::int64_t most, std::int64_t& drawn) {
  drawn = choices.integer(0, most);
  return std::ldexp(static_cast<double>(drawn), -kDoubleBits);
}

/// Corners of a sub-domain, any doubles: the paper takes them as exact.
std::array<Uv<double>, 3> draw_corners(Draw& choices, const Shape& shape) {
  constexpr std::int64_t kOne = std::int64_t{1} << kDoubleBits;
  std::array<Uv<double>, 3> corners{};
  for (Uv<double>& corner : corners) {
    std::int64_t u = 0, v = 0;
    corner[0] = draw_fraction(choices, kOne, u);
    corner[1] = draw_fraction(choices, shape.kind == ShapeKind::kTriangle ? kOne - u : kOne, v);
  }
  return corners;
}

/// Coordinates of 53 bits.
Points<double> draw_full_points(Draw& choices, const Shape& shape) {
  return to_doubles(draw_points(choices, shape, kDoubleBits, -50)).value();
}

/// With coordinates of 53 bits.
MovingPatch<double> draw_full_patch(Draw& d, bool weighted) {
  constexpr int kDegree = 3;
  MovingPatch<double> patch;
  patch.shape = show(d, "shape", draw_surface(d, kDegree));
  patch.positions = show(d, "positions", draw_full_points(d, patch.shape));
  patch.velocities = show(d, "velocities", draw_full_points(d, patch.shape));
  if (weighted) {
    patch.weights = show(d, "weights", draw_patch_weights(d, patch.positions.size()));
    suppose(patch.is_rational());
  }
  return patch;
}

/// (b): the control points of a sub-patch are off by at most eps_cp. (B, k) = (P, 3(n + m)) for
/// tensor patches, the paper's 6n where n = m, and (2^n P, 5n) for triangles. So are those of a
/// rational patch (src/ccd/DERIVATION.md), as these corners leave 1 − u and 1 − u − v exact.
void check_sub_patch_error(Draw& d, bool weighted) {
  const MovingPatch<double> patch = draw_full_patch(d, weighted);
  const Shape& shape = patch.shape;
  const auto corners = show(d, "corners", draw_corners(d, shape));
  const MovingPatch<double> rounded = restrict_to(patch, corners);
  const MovingPatch<Rational> exactly =
      restrict_to(exact_patch<Rational>(patch), exact_corners<Rational>(corners));
  const Dyadic largest = Dyadic::exact(largest_components_of(patch).position);
  const bool triangle = shape.kind == ShapeKind::kTriangle;
  const Rational bound = (triangle ? theorem_4_1_bound(largest.scaled(shape.n), 5 * shape.n)
                                   : theorem_4_1_bound(largest, 3 * (shape.n + shape.m)))
                             .rational();
  for (std::size_t i = 0; i < patch.positions.size(); ++i) {
    show(d, "control point", i);
    for (int k = 0; k < 3; ++k) {
      CLAIM(abs(exact(rounded.positions[i][k]) - exactly.positions[i][k]) <= bound);
    }
  }
}

/// The 15 axes as (c) makes them from four spans, in any number type.
template <class S>
std::array<Vec3<S>, 15> axes_of_spans(const std::array<Vec3<S>, 4>& spans) {
  std::array<Vec3<S>, 15> l;
  l[0] = spans[0], l[1] = cross(spans[0], spans[1]), l[2] = cross(l[0], l[1]);
  l[3] = spans[2], l[4] = cross(spans[2], spans[3]), l[5] = cross(l[3], l[4]);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) l[3 * i + j + 6] = cross(l[i], l[j + 3]);
  }
  return l;
}

/// (c): component errors of the axes are within B = 2^s·A^(s+1), k = 2s at s cross products.
void check_axis_error(Draw& d) {
  constexpr std::array kStages = {0, 1, 2, 0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 5};
  std::array<Vec3<double>, 4> spans;
  std::array<Vec3<Dyadic>, 4> exact_spans;
  Dyadic largest;
  for (std::size_t s = 0; s < 4; ++s) {
    for (int k = 0; k < 3; ++k) {
      exact_spans[s][k] = d.dyadic(kDoubleBits, -kDoubleBits);
      spans[s][k] = *exact_spans[s][k].to_double_exactly();
      if (largest < abs(exact_spans[s][k])) largest = abs(exact_spans[s][k]);
    }
    show(d, "span", spans[s]);
  }
  const auto rounded = axes_of_spans(spans);
  const auto exact = axes_of_spans(exact_spans);
  for (std::size_t r = 0; r < rounded.size(); ++r) {
    Dyadic magnitude = largest;
    for (int s = 0; s < kStages[r]; ++s) magnitude = (magnitude * largest).scaled(1);
    const Dyadic bound = theorem_4_1_bound(magnitude, 2 * kStages[r]);
    show(d, "axis", r + 1);
    for (int k = 0; k < 3; ++k) CLAIM(abs(Dyadic::exact(rounded[r][k]) - exact[r][k]) <= bound);
  }
}

/// (d): slopes and intercepts of a sub-patch on an axis, the axis as it is in doubles. Its k of a
/// rational patch counts no roundings behind weights: what Appendix B adds is for them.
void check_coefficient_error(Draw& d, bool weighted) {
  constexpr int kDepth = 10;
  Query query;
  for (MovingPatch<double>& patch : query.patches) patch = draw_full_patch(d, weighted);
  const MovingPatch<double>& patch = query.patches[0];
  const Shape& shape = patch.shape;
  const std::array<Cell, 2> cells = {draw_cell(d, shape, kDepth), Cell()};
  SubPatches parts(kAsInAppendixA.axes);
  parts.begin(query);
  for (int s = 0; s < 2; ++s) parts.prepare(s, {&cells[static_cast<std::size_t>(s)], 1});
  const ObbAxes axes = parts.axes(0, 0, 0.5);
  const int r = d.integer(0, ObbAxes::kCount - 1);
  const Axis axis = axes[r];
  const LargestComponents extent = largest_components_of(patch);
  const CoefficientError bound = coefficient_error(shape, extent, axis);
  const auto corners = cells[0].corners(shape);
  const MovingPatch<Rational> exactly =
      restrict_to(exact_patch<Rational>(patch), exact_corners<Rational>(corners));
  show(d, "axis", r + 1);
  show(d, "corners", corners);
  if (weighted) {
    const bool triangle = shape.kind == ShapeKind::kTriangle;
    const int k_cp = 3 * (triangle ? 2 * shape.n : shape.n + shape.m);
    const Dyadic magnitude = (Dyadic(3) * Dyadic::exact(extent.position))
                                 .scaled(std::max(shape.n, shape.m) + axis.stage);
    CLAIM(theorem_4_1_bound(magnitude, 2 * k_cp + 2 + 2 * axis.stage + 3) <=
          Dyadic::exact(bound.intercept));
  }
  const ControlNet net = parts.net(0, 0);
  const Vec3<Rational> direction = exact(axis.direction);
  Lines<double> line;
  for (std::size_t i = 0; i < net.positions.size(); ++i) {
    project({Shape::point(), net.positions.subspan(i, 1), net.velocities.subspan(i, 1)}, axis,
            line);
    const Rational slope = dot(direction, exactly.velocities[i]);
    const Rational intercept = dot(direction, exactly.positions[i]);
    show(d, "control point", i);
    CLAIM(abs(exact(line[0].slope) - slope) <= exact(bound.slope));
    CLAIM(abs(exact(line[0].intercept) - intercept) <= exact(bound.intercept));
  }
}

}  // namespace

std::vector<Property> coefficients_claims() {
  const auto of = [](void (*check)(Draw&, bool), bool weighted) {
    return [=](Draw& d) { check(d, weighted); };
  };
  return {
      {"paper.sub_patch_error",
       "The control points of a sub-patch are within eps_cp, k = 3(n + m) for tensor patches",
       "Appendix A (b)", of(check_sub_patch_error, false)},
      {"paper.sub_patch_error_weighted", "The same of rational patches, by the same k",
       "Appendix A (b); Section 7, NURBS", of(check_sub_patch_error, true)},
      {"paper.axis_error", "The components of the 15 axes, not normalised, are within eps_l",
       "Appendix A (c)", check_axis_error},
      {"tdibm-e.coefficient_error",
       "The slope and intercept of each control point of a part on an axis are within eps_a, eps_b",
       "Appendix A (d)", of(check_coefficient_error, false)},
      {"tdibm-e.coefficient_error_weighted",
       "The same of rational patches. eps_b is no less than by k with all roundings of weights",
       "Appendices A (d) and B; Section 7, NURBS", of(check_coefficient_error, true)},
  };
}

}  // namespace ccdfuzz
