#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "ccd/axes.hpp"
#include "ccd/projection.hpp"
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

/// (b): the control points of a sub-patch are off by at most eps_cp. (B, k) = (P, 3(n + m)) for
/// tensor patches, the paper's 6n where n = m, and (2^n P, 5n) for triangles.
void check_sub_patch_error(Draw& d) {
  constexpr int kDegree = 3;
  const Shape shape = show(d, "shape", draw_surface(d, kDegree));
  const auto corners = show(d, "corners", draw_corners(d, shape));
  const Points<double> points = show(d, "points", draw_full_points(d, shape));
  Points<double> rounded(points.size());
  restrict_to<double>(shape, points, corners, rounded);
  Points<Dyadic> whole, exact(points.size());
  for (const Vec3<double>& p : points) whole.push_back(exact_dyadic(p));
  restrict_to<Dyadic>(shape, whole, exact_corners<Dyadic>(corners), exact);
  const Dyadic largest = Dyadic::exact(largest_components_of({shape, points, points}).position);
  const bool triangle = shape.kind == ShapeKind::kTriangle;
  const Dyadic bound = triangle ? theorem_4_1_bound(largest.scaled(shape.n), 5 * shape.n)
                                : theorem_4_1_bound(largest, 3 * (shape.n + shape.m));
  for (std::size_t i = 0; i < points.size(); ++i) {
    show(d, "control point", i);
    for (int k = 0; k < 3; ++k) CLAIM(abs(Dyadic::exact(rounded[i][k]) - exact[i][k]) <= bound);
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

/// (d): slopes and intercepts of a sub-patch on an axis, the axis as it is in doubles.
void check_coefficient_error(Draw& d) {
  constexpr int kDegree = 3, kDepth = 10;
  std::array<MovingPatch<double>, 2> patches, parts;
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = patches[s];
    patch.shape = draw_surface(d, kDegree);
    patch.positions = draw_full_points(d, patch.shape);
    patch.velocities = draw_full_points(d, patch.shape);
  }
  const auto corners = draw_cell(d, patches[0].shape, kDepth).corners(patches[0].shape);
  parts[0] = restrict_to(patches[0], corners);
  parts[1] = patches[1];
  const AxisReading reading = kAsInAppendixA.axes;
  const auto frame = [&](int side) {
    const MovingPatch<double>& part = parts[static_cast<std::size_t>(side)];
    return obb_frame({part.shape, part.positions, part.velocities}, 0.5, reading, side);
  };
  const ObbAxes axes(frame(0), frame(1), reading.length);
  const int r = d.integer(0, ObbAxes::kCount - 1);
  const Axis axis = axes[r];
  const Vec3<Dyadic> direction =
      exact_dyadic({axis.direction[0], axis.direction[1], axis.direction[2]});
  const CoefficientError bound =
      coefficient_error(patches[0].shape, largest_components_of(patches[0]), axis);
  const MovingPatch<Dyadic> exact =
      restrict_to(exact_patch<Dyadic>(patches[0]), exact_corners<Dyadic>(corners));
  show(d, "axis", r + 1);
  show(d, "shape", patches[0].shape);
  show(d, "corners", corners);
  show(d, "positions", patches[0].positions);
  show(d, "velocities", patches[0].velocities);
  Lines<double> line;
  for (std::size_t i = 0; i < parts[0].positions.size(); ++i) {
    project({Shape::point(), {&parts[0].positions[i], 1}, {&parts[0].velocities[i], 1}}, axis,
            line);
    const Dyadic slope = dot(direction, exact.velocities[i]);
    const Dyadic intercept = dot(direction, exact.positions[i]);
    show(d, "control point", i);
    CLAIM(abs(Dyadic::exact(line[0].slope) - slope) <= Dyadic::exact(bound.slope));
    CLAIM(abs(Dyadic::exact(line[0].intercept) - intercept) <= Dyadic::exact(bound.intercept));
  }
}

}  // namespace

std::vector<Property> coefficients_claims() {
  return {
      {"paper.sub_patch_error",
       "The control points of a sub-patch are within eps_cp, k = 3(n + m) for tensor patches",
       "Appendix A (b)", check_sub_patch_error},
      {"paper.axis_error", "The components of the 15 axes, not normalised, are within eps_l",
       "Appendix A (c)", check_axis_error},
      {"tdibm-e.coefficient_error",
       "The slope and intercept of each control point of a part on an axis are within eps_a, eps_b",
       "Appendix A (d)", check_coefficient_error},
  };
}

}  // namespace ccdfuzz
