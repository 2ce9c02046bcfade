#include <algorithm>
#include <cmath>
#include <limits>

#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "case/scale.hpp"
#include "ccd/certified/cell_tree.hpp"
#include "ccd/certified/kernels.hpp"
#include "ccd/certified/normalise.hpp"
#include "ccd/certified/projection.hpp"
#include "ccd/certified/window_trim.hpp"
#include "generators/draw_patch.hpp"
#include "properties/error_bound.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// One component, before and after, and by how much the latter may be off.
struct Pair {
  Dyadic given, stored, error;
};

/// Whether some c has |stored − 2^scale·(given − c)| ≤ error for all. Some has if two at a time
/// agree on one, since what agrees with each is an interval.
bool is_moved_by_one(const std::vector<Pair>& pairs, long scale) {
  for (const Pair& p : pairs) {
    for (const Pair& q : pairs) {
      const Dyadic off = (p.stored - q.stored) - (p.given - q.given).scaled(scale);
      if (p.error + q.error < abs(off)) return false;
    }
  }
  return true;
}

/// Component k of all positions, or of all velocities where k > 2: off by u·|2^scale·(given − c)| +
/// absolute at most.
std::vector<Pair> pairs_of(const Query& query, const certified::NormalisedQuery& normalised,
                           std::size_t k) {
  const Dyadic absolute = Dyadic::exact(normalised.absolute);
  std::vector<Pair> pairs;
  for (std::size_t s = 0; s < 2; ++s) {
    const auto& patch = query.patches[s];
    for (std::size_t i = 0; i < patch.positions.size(); ++i) {
      const Vec3<double>& from = k < 3 ? patch.positions[i] : patch.velocities[i];
      const Dyadic stored = Dyadic::exact(normalised.controls[s][i][k]);
      // The x that is meant has |x| ≤ (|stored| + absolute)/(1 − u), and 1/(1 − u) ≤ 1 + 2u.
      const Dyadic most = (abs(stored) + absolute) * (Dyadic(1) + half_ulp().scaled(1));
      pairs.push_back(
          {Dyadic::exact(from[static_cast<int>(k % 3)]), stored, half_ulp() * most + absolute});
    }
  }
  return pairs;
}

/// What underflow takes at most, in scaled lengths. Numbers are made four times smaller where one
/// is 2^1022 or more, which costs each of them an eta on that scale. Where that is no double,
/// `absolute` is infinite, and nothing is certified.
Dyadic most_underflow(const Query& query, const certified::NormalisedQuery& normalised) {
  constexpr int kShift = 2;
  const int scale = normalised.space + kShift;
  const auto& [a, b] = query.patches;
  const double fastest =
      std::max(largest_coordinate(a.velocities), largest_coordinate(b.velocities));
  Dyadic most;
  if (largest_coordinate(query) >= 0x1p1022) most += least_double().scaled(scale);
  if (fastest >= 0x1p1022 && query.t_max != 0) {
    most += least_double().scaled(scale + normalised.time);
  }
  return most;
}

/// Ends in normal form: t·|v' − v''| ≤ 2u·(|p''| + |v''|) + t·absolute at t = t_max.
void check_normalised_ends(Draw& d) {
  const Query query = show(d, "query", supposed(with_drawn_ends(draw_extreme_query(d), d)));
  certified::NormalisedQuery out;
  certified::normalise(query, out);
  suppose(query.t_max > 0 && std::isfinite(out.absolute));
  CLAIM(out.roundings == 2);
  const Dyadic absolute = Dyadic::exact(out.absolute), t = Dyadic::exact(out.t_max);
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Pair> ways;  // times t
    for (std::size_t s = 0; s < 2; ++s) {
      const MovingPatch<Dyadic> exact_way = exact_patch<Dyadic>(query.patches[s]);
      for (std::size_t i = 0; i < exact_way.positions.size(); ++i) {
        const Dyadic p = Dyadic::exact(out.controls[s][i][k]),
                     v = Dyadic::exact(out.controls[s][i][k + 3]);
        const auto axis = static_cast<Eigen::Index>(k);
        const Dyadic most =
            (abs(p) + abs(v) * t + absolute.scaled(1)) * (Dyadic(1) + half_ulp().scaled(2));
        ways.push_back(
            {exact_way.velocities[i][axis] * t, v * t, half_ulp().scaled(1) * most + absolute * t});
      }
    }
    CLAIM(is_moved_by_one(pairs_of(query, out, k), out.space));
    CLAIM(is_moved_by_one(ways, out.space + out.time));
  }
}

void check_normalised(Draw& d) {
  const Query query = show(d, "query", draw_extreme_query(d));
  certified::NormalisedQuery out;
  certified::normalise(query, out);
  show(d, "space", out.space);
  show(d, "time", out.time);
  show(d, "t_max", out.t_max);
  show(d, "absolute", out.absolute);
  CLAIM(Dyadic::exact(out.t_max).scaled(out.time) == Dyadic::exact(query.t_max));
  CLAIM(out.t_max == 0 || (0.5 <= out.t_max && out.t_max < 1));
  CLAIM(out.absolute >= certified::kLeastAbsolute);
  if (std::isinf(out.absolute)) {
    CLAIM(most_underflow(query, out) >= Dyadic::exact(std::numeric_limits<double>::max()));
    return;
  }
  for (std::size_t k = 0; k < 6; ++k) {
    const bool is_position = k < 3;
    if (!is_position && query.t_max == 0) continue;  // nothing moves in no time
    show(d, "component", k);
    const std::vector<Pair> pairs = pairs_of(query, out, k);
    for (const Pair& pair : pairs) CLAIM(abs(pair.stored) <= Dyadic(1));
    const long scale = out.space + (is_position ? 0 : out.time);
    CLAIM(is_moved_by_one(pairs, scale));
  }
  Dyadic magnitude;
  for (std::size_t s = 0; s < 2; ++s) {
    Dyadic position, velocity;
    for (const auto& x : out.controls[s]) {
      for (std::size_t k = 0; k < 3; ++k) {
        position = std::max(position, abs(Dyadic::exact(x[k])));
        velocity = std::max(velocity, abs(Dyadic::exact(x[k + 3])));
      }
    }
    magnitude += position + velocity;
  }
  // Three sums, each u too low at most.
  const Dyadic lost = magnitude * half_ulp() * Dyadic(3);
  CLAIM(magnitude - lost <= Dyadic::exact(out.magnitude));
}

/// A cell of a net, plain or rational. Control points are of magnitude at most 1; a few components
/// are of subnormal numbers throughout. Exponents of weights differ by up to kWeightBits.
struct DrawnCell {
  Shape shape;
  std::vector<std::array<double, 6>> controls;
  std::vector<double> weights;
  certified::CellTree tree;
  certified::CellTree::Node node = 0;
  Cell cell;

  DrawnCell(Draw& d, bool is_rational) : shape(draw_shape(d, is_rational ? 3 : 4)) {
    const auto count = static_cast<std::size_t>(shape.control_count());
    controls.resize(count);
    for (std::size_t k = 0; k < 6; ++k) {
      const bool is_subnormal = d.choose(3) == 3;
      for (auto& control : controls) {
        control[k] = *(is_subnormal ? d.dyadic(8, -1074) : d.dyadic(53, -53)).to_double_exactly();
      }
    }
    if (is_rational) {
      for (std::size_t i = 0; i < count; ++i) weights.push_back(draw_weight(d));
      weights[d.below(count)] = 1;
    }
    tree.reset(shape, controls, weights);
    for (auto levels = d.choose(6); levels > 0; --levels) {
      const auto which = d.choose(static_cast<std::uint64_t>(shape.child_count() - 1));
      node = tree.children(node) + static_cast<certified::CellTree::Node>(which);
    }
    cell = tree.cell(node);
    show(d, "shape", shape);
    show(d, "cell", cell);
    show(d, "controls", controls);
    show(d, "weights", weights);
  }

  static double draw_weight(Draw& d) {
    const int exponent = d.coin() ? 0 : -d.integer(0, kWeightBits);
    return std::ldexp(1 + *abs(d.dyadic(30, -31)).to_double_exactly(), exponent);
  }
  int roundings() const { return tree.roundings(tree.depth(node)); }
  /// Each argument of each blossom is one (src/ccd/certified/DERIVATION.md, 2).
  int averages() const { return (shape.n + shape.m) * tree.depth(node); }
};

void check_sub_patches(Draw& d) {
  const DrawnCell drawn(d, false);
  const auto& controls = drawn.controls;
  const int roundings = show(d, "roundings", drawn.roundings());
  CLAIM(roundings >= drawn.averages());
  const auto corners = exact_corners<Dyadic>(drawn.cell.corners(drawn.shape));
  const Dyadic underflow = Dyadic(roundings) * least_double().scaled(-1);
  for (std::size_t part = 0; part < 2; ++part) {
    Points<Dyadic> whole(controls.size()), exact(controls.size());
    Vec3<Dyadic> most;
    for (std::size_t i = 0; i < controls.size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        whole[i][c] = Dyadic::exact(controls[i][3 * part + static_cast<std::size_t>(c)]);
        most[c] = std::max(most[c], abs(whole[i][c]));
      }
    }
    restrict_to<Dyadic>(drawn.shape, whole, corners, exact);
    for (std::size_t i = 0; i < controls.size(); ++i) {
      show(d, part == 0 ? "position" : "velocity", i);
      for (int c = 0; c < 3; ++c) {
        const std::size_t place = i * certified::kPerPoint + 4 * part + static_cast<std::size_t>(c);
        const Dyadic made = Dyadic::exact(drawn.tree.net(drawn.node)[place]);
        CLAIM(abs(made - exact[i][c]) <= within_roundings(roundings) * most[c] + underflow);
      }
    }
  }
}

/// Control points of rational cells at a time, and their heights on an axis, are off by the
/// roundings that tdibm-c counts at most.
void check_rational_cells(Draw& d) {
  const DrawnCell drawn(d, true);
  const auto& [shape, controls, weights, tree, node, cell] = drawn;
  suppose(shape.kind != ShapeKind::kPoint);
  const double t = show(d, "t", *abs(d.dyadic(53, -53)).to_double_exactly());
  MovingPatch<Rational> whole{shape, {}, {}};
  Rational largest_p = 0, largest_v = 0;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const auto& c = controls[i];
    whole.positions.push_back({exact(c[0]), exact(c[1]), exact(c[2])});
    whole.velocities.push_back({exact(c[3]), exact(c[4]), exact(c[5])});
    whole.weights.push_back(exact(weights[i]));
    for (std::size_t k = 0; k < 3; ++k) {
      largest_p = std::max(largest_p, Rational(abs(exact(c[k]))));
      largest_v = std::max(largest_v, Rational(abs(exact(c[k + 3]))));
    }
  }
  const MovingPatch<Rational> part =
      restrict_to<Rational>(whole, exact_corners<Rational>(cell.corners(shape)));
  const Points<Rational> at = part.at(exact(t));
  std::vector<double> snapshot(certified::kPerPoint * controls.size());
  certified::take_snapshot(tree.net(node), tree.count(), 0, t, snapshot.data());
  const int roundings = drawn.roundings();
  CLAIM(roundings == 2 * drawn.averages() + 2);
  const auto within = [&](int count) -> Rational {
    const Rational relative = exact(std::ldexp(count, -53)) * (1 + power_of_two(-20));
    return relative * (largest_p + largest_v) + power_of_two(-1001);
  };
  // One more of the product with t, and one of the sum.
  const Rational allowed = within(roundings + 2);
  certified::Axis axis;
  for (double& x : axis) x = *d.dyadic(53, -53).to_double_exactly();
  const certified::NetPair pair = {{tree.net(node), tree.net(node)}, {tree.count(), tree.count()}};
  const certified::HeightLines lines(pair, axis);
  Rational highest, lowest, norm;
  for (std::size_t i = 0; i < at.size(); ++i) {
    Rational height = 0;
    for (int k = 0; k < 3; ++k) {
      const auto place = certified::kPerPoint * i + 4 + static_cast<std::size_t>(k);
      CLAIM(abs(exact(snapshot[place]) - at[i][k]) <= allowed);
      height += exact(axis[static_cast<std::size_t>(k)]) * at[i][k];
    }
    highest = i == 0 ? height : std::max(highest, height);
    lowest = i == 0 ? height : std::min(lowest, height);
    CLAIM(snapshot[certified::kPerPoint * i + 7] == 0);
  }
  for (const double x : axis) norm += exact(std::abs(x));
  const Rational off = abs(exact(lines.gap(0, t).height) - (highest - lowest));
  CLAIM(off <= 2 * within(roundings + 8) * norm + power_of_two(-1000));
}

void check_derived_bound(Draw& d) {
  constexpr int kMostRoundings = 16 * 50;  // D·d
  const int count = show(d, "roundings", d.integer(0, kMostRoundings));
  const double magnitude = show(d, "M", *abs(d.dyadic(53, -51)).to_double_exactly());
  const double absolute = show(d, "absolute", std::ldexp(1.0, d.integer(-1000, -10)));
  certified::Axis axis;
  // Axes are products of edges, which become as short as cells.
  const int shorter = d.coin() ? d.integer(-600, 0) : 0;
  for (double& x : axis) x = *d.dyadic(53, -51).scaled(shorter).to_double_exactly();
  const double separation = d.coin() ? *abs(d.dyadic(53, -51)).to_double_exactly() : 0;
  const certified::HeightErrorBound bound(magnitude, absolute, count, separation);
  certified::AxisBatch batch;
  for (std::size_t k = 0; k < 3; ++k) batch.axes[k][0] = axis[k];
  Dyadic norm;
  Dyadic norm_squared;
  for (const double x : axis) {
    norm += abs(Dyadic::exact(x));
    norm_squared += Dyadic::exact(x) * Dyadic::exact(x);
  }
  const Dyadic derived = derived_error(magnitude, absolute, count, norm);
  show(d, "axis", axis);
  show(d, "separation", separation);
  const Dyadic apart = Dyadic::exact(separation);
  for (const double e : {bound.for_axis(axis), bound.for_axes(batch).on[0]}) {
    const Dyadic rest = Dyadic::exact(e) - derived;
    CLAIM(rest.sign() >= 0);
    CLAIM(rest * rest >= apart * apart * norm_squared);
  }
  CLAIM(separation > 0 || bound.for_axis(axis) == bound.of_rounding(axis));
}

double draw_fraction(Draw& d) {
  return d.dyadic(53, -53).to_double_exactly().value();
}

/// Law B: what is dropped lies where the chord is below zero.
void check_chord_root(Draw& d) {
  const double t0 = show(d, "t0", std::abs(draw_fraction(d)));
  const double t1 = show(d, "t1", std::abs(draw_fraction(d)));
  suppose(t0 != t1);
  const int least = -1070;
  const int e0 = d.integer(least, 0);
  const double h0 = show(d, "h0", -std::ldexp(1 + std::abs(draw_fraction(d)), e0 - 1));
  const int e1 = d.coin() ? e0 : d.integer(least, 0);
  const double h1 = show(d, "h1", std::ldexp(std::abs(draw_fraction(d)), e1));
  const double root = show(d, "root", certified::chord_root(t0, h0, t1, h1));
  const Rational exact_root =
      exact(t0) - (exact(t1) - exact(t0)) * exact(h0) / (exact(h1) - exact(h0));
  CLAIM(t0 < t1 ? exact(root) <= exact_root : exact(root) >= exact_root);
  CLAIM(t0 < t1 ? root >= t0 : root <= t0);
}

}  // namespace

std::vector<Property> certified_bounds_claims() {
  return {
      {"tdibm-c.normalised",
       "The normalised control points of any finite doubles, also of ends, are those of the query, "
       "moved and scaled alike, up to the stated errors, and of magnitude 1 at most",
       "src/ccd/certified/normalise.hpp",
       [](Draw& d) { d.coin() ? check_normalised_ends(d) : check_normalised(d); }},
      {"tdibm-c.sub_patches",
       "Control points of cells are off by at most the roundings that are counted",
       "src/ccd/certified/DERIVATION.md, 2", check_sub_patches},
      {"tdibm-c.cells_weighted",
       "Control points of cells of rational patches are off by the roundings counted at most",
       "src/ccd/certified/DERIVATION.md, 9", check_rational_cells},
      {"tdibm-c.error_bound", "The error bound E is at least the derived one",
       "src/ccd/certified/DERIVATION.md, 3", check_derived_bound},
      {"tdibm-c.chord_root", "The computed root of a chord is never past the exact one",
       "src/ccd/certified/DERIVATION.md, 4", check_chord_root},
  };
}

}  // namespace ccdfuzz
