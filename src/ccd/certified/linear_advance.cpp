#include "ccd/certified/linear_advance.hpp"

#include <algorithm>
#include <limits>

#include "bezier/bernstein.hpp"
#include "ccd/certified/linear_differences.hpp"
#include "ccd/certified/projection.hpp"
#include "numeric/next_double.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz::certified {

namespace {

/// Steps after which roots decide (rough_contact.hpp). Nearly all queries take one or two; where
/// the patches turn against each other, steps become shorter only by a factor.
constexpr int kMostSteps = 3;
/// The same of a point and an edge, or of two points, which are always in a plane with the origin.
/// Roots tell nothing there, and integers take as long as twenty steps.
constexpr int kMostStepsInPlane = 8;
/// The same where a separation is asked for, of which nothing else decides. Let the patches be
/// nearest at some time, and about the separation apart there. A step towards that time halves the
/// way left, so a step of 2^-44 is reached in fewer, unless edges turn across each other.
constexpr int kMostStepsApart = 200;
/// Stop after a step shorter than this part of t_max: the patches are then within about a hundred
/// times the error bound of each other.
constexpr double kShortestStep = 0x1p-44;

Axis scaled(const Axis& a, double s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}

/// The part of v that is normal to the edge, times the square of its length. What rounding leaves
/// along the edge is u of it, however near to parallel the vectors were that v is made from.
Axis across(const Axis& v, const Axis& edge) {
  return cross(edge, cross(v, edge));
}

double unit_clamp(double x) {
  return std::clamp(x, 0.0, 1.0);
}

/// Weights x, y of the point d + x·e − y·f nearest to the origin, x and y in [0, 1]. Where edges
/// are parallel but for rounding, the point may be farther by about 2^-26 of the size.
std::array<double, 2> nearest_of_edges(const Axis& d, const Axis& e, const Axis& f) {
  const double ee = dot(e, e), ff = dot(f, f), ef = dot(e, f);
  const double de = dot(d, e), df = dot(d, f);
  const double area = ee * ff - ef * ef;
  double x = area > 0 ? unit_clamp((ef * df - ff * de) / area) : 0.5;
  double y = ff > 0 ? (df + x * ef) / ff : 0;
  if (ff == 0 || y < 0 || y > 1) {
    y = unit_clamp(y);
    x = ee > 0 ? unit_clamp((y * ef - de) / ee) : 0;
  }
  return {x, y};
}

/// The shortest vector d + x·e − y·f, x and y in [0, 1], but for a few roundings of d, e and f. It
/// is from an end of an edge to the other edge, or between inner points.
Axis shortest_between_edges(const Axis& d, const Axis& e, const Axis& f) {
  Axis shortest = d;
  double least = std::numeric_limits<double>::infinity();
  // `from` and an edge that begins at the origin.
  const auto consider = [&](const Axis& from, const Axis& edge) {
    const double length = dot(edge, edge);
    const double share = length > 0 ? unit_clamp(dot(from, edge) / length) : 0;
    const Axis between = minus(from, scaled(edge, share));
    if (const double squared = dot(between, between); squared < least) {
      least = squared;
      shortest = between;
    }
  };
  const Axis back = scaled(e, -1), normal = cross(e, f);
  consider(d, f);
  consider(plus(d, e), f);
  consider(d, back);
  consider(minus(d, f), back);
  // From the cross product, as a difference of dot products loses the square of the angle.
  if (const double squared = dot(normal, normal); squared > 0) {
    const double x = unit_clamp(dot(cross(f, d), normal) / squared);
    consider(plus(d, scaled(e, x)), f);
  }
  return shortest;
}

/// Weights of b and c in the point of the triangle a, b, c nearest to the origin: on an edge or
/// inside. The nearer one counts, as rounding may say inside where the corners are on a line.
std::array<double, 2> nearest_of_face(const Axis& a, const Axis& b, const Axis& c) {
  const Axis ab = minus(b, a), ac = minus(c, a);
  const double b1 = -dot(ab, a), c1 = -dot(ac, a);
  const double b2 = -dot(ab, b), c2 = -dot(ac, b);
  const double b3 = -dot(ab, c), c3 = -dot(ac, c);
  std::array<double, 2> nearest{};
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](double of_b, double of_c) {
    const Axis p = plus(a, plus(scaled(ab, of_b), scaled(ac, of_c)));
    if (const double squared = dot(p, p); squared < least) {
      least = squared;
      nearest = {of_b, of_c};
    }
  };
  // From what an edge's direction has towards the origin at its ends.
  const auto share = [](double from, double to) {
    if (from <= 0) return 0.0;
    return to < 0 ? from / (from - to) : 1.0;
  };
  consider(share(b1, b2), 0);
  consider(0, share(c1, c3));
  const double of_bc = share(c2 - b2, c3 - b3);
  consider(1 - of_bc, of_bc);
  const double of_a = b2 * c3 - b3 * c2, of_b = b3 * c1 - b1 * c3, of_c = b1 * c2 - b2 * c1;
  const double sum = (of_a + of_b) + of_c;
  if (of_a > 0 && of_b > 0 && of_c > 0) consider(of_b / sum, of_c / sum);
  return nearest;
}

/// Inside of a face's domain, though they are rounded. One of 1 − u and 1 − v is exact.
Uv<double> inside_of_face(const Uv<double>& uv) {
  const auto& [u, v_or_more] = uv;
  const double v = std::min(v_or_more, 1 - u);
  return {u, u > 1 - v ? next_down(v) : v};
}

class ConservativeAdvancement {
 public:
  ConservativeAdvancement(const NormalisedQuery& query, ExclusionObserver* observer)
      : query_(query),
        observer_(observer),
        differences_(query),
        error_(query.magnitude, query.absolute, query.roundings, query.separation) {}

  Advancement run() {
    for (size_t k = 0; k < 3; ++k) {
      follow(coordinate_axis(static_cast<int>(k)));
      if (clear_) return {Advancement::Kind::kClear, query_.t_max};
    }
    Advancement out;
    time_ = furthest_;
    const bool in_plane = query_.controls[0].size() + query_.controls[1].size() < 4;
    const int most_steps = query_.separation > 0 ? kMostStepsApart
                           : in_plane            ? kMostStepsInPlane
                                                 : kMostSteps;
    for (int steps = 0; steps < most_steps; ++steps) {
      differences_.is_face ? try_axes_of_face() : try_axes_of_edges();
      if (clear_) {
        out.kind = Advancement::Kind::kClear;
        return out;
      }
      const double step = furthest_ - time_;
      time_ = furthest_;
      out.time = time_;
      if (step <= kShortestStep * query_.t_max) {
        out.kind = Advancement::Kind::kStopped;
        return out;
      }
    }
    return out;
  }

 private:
  /// Follows an axis from time_ on, if it separates there, either side up. By Law A of the
  /// derivation nothing touches in between, as it separates at both ends.
  void follow(const Axis& l) {
    ++tried_;
    const double e = error_.for_axis(l), likely = e + 0.5 * error_.of_rounding(l);
    std::array<double, 4> height, slope;
    int above = 0, below = 0;
    for (int i = 0; i < differences_.count; ++i) {
      const auto n = static_cast<size_t>(i);
      height[n] = dot(l, differences_.start[n]);
      slope[n] = dot(l, differences_.way[n]);
      const double now = slope[n] * time_ + height[n];
      above += now > e;
      below += now < -e;
    }
    if (observer_ != nullptr) report_gaps(l, e, height, slope);
    if (above != differences_.count && below != differences_.count) return;
    const double side = above == differences_.count ? 1 : -1;
    const auto separated_at = [&](double t) {
      for (int i = 0; i < differences_.count; ++i) {
        const auto n = static_cast<size_t>(i);
        if (!(side * (slope[n] * t + height[n]) > e)) return false;
      }
      return true;
    };
    const auto report = [&](double end) {
      if (observer_ == nullptr) return;
      // A difference is of this side's point less the other's.
      const int of = differences_.face_side;
      observer_->excluded(
          {tried_, {l[0], l[1], l[2]}, side > 0 ? 1 - of : of, {time_, end, true, true}});
    };
    if (separated_at(query_.t_max)) {
      report(query_.t_max);
      clear_ = true;
      return;
    }
    // Aim at 1.5·E so that the check below, which needs E, passes.
    double end = query_.t_max;
    for (int i = 0; i < differences_.count; ++i) {
      const auto n = static_cast<size_t>(i);
      if (side * slope[n] >= 0) continue;
      end = std::min(end, (side * height[n] - likely) / (-side * slope[n]));
    }
    if (end > furthest_ && separated_at(end)) {
      report(end);
      furthest_ = end;
    }
  }

  /// Tells the observer the gaps on an axis, at the time reached and at t_max.
  void report_gaps(const Axis& l, double e, const std::array<double, 4>& height,
                   const std::array<double, 4>& slope) const {
    for (const int below : {0, 1}) {
      // A difference is of this side's point less the other's.
      const double sign = below == differences_.face_side ? 1 : -1;
      const auto gap_at = [&](double t) {
        double most = sign * (slope[0] * t + height[0]);
        for (size_t n = 1; n < static_cast<size_t>(differences_.count); ++n) {
          most = std::max(most, sign * (slope[n] * t + height[n]));
        }
        return most + e;
      };
      observer_->compared({tried_,
                           {l[0], l[1], l[2]},
                           below,
                           {time_, query_.t_max},
                           gap_at(time_),
                           gap_at(query_.t_max),
                           e});
    }
  }

  void try_axes_of_edges() {
    const Axis d = differences_.at(0, time_);
    const Axis e = minus(differences_.at(1, time_), d), f = minus(d, differences_.at(2, time_));
    const bool is_apart = query_.separation > 0;
    const Axis normal = cross(e, f);
    follow(is_apart ? across(normal, e) : normal);
    if (clear_) return;
    const Axis nearest = [&] {
      if (is_apart) return shortest_between_edges(d, e, f);
      const auto [x, y] = nearest_of_edges(d, e, f);
      return minus(plus(d, scaled(e, x)), scaled(f, y));
    }();
    follow(nearest);
    for (const Axis& edge : {e, f}) {
      if (clear_) return;
      follow(across(is_apart ? nearest : d, edge));
    }
  }

  void try_axes_of_face() {
    const Axis a = differences_.at(0, time_), b = differences_.at(1, time_),
               c = differences_.at(2, time_);
    const Axis ab = minus(b, a), ac = minus(c, a), bc = minus(c, b);
    const Axis normal = cross(ab, ac);
    follow(query_.separation > 0 ? across(normal, ab) : normal);
    if (clear_) return;
    const auto [of_b, of_c] = nearest_of_face(a, b, c);
    follow(plus(a, plus(scaled(ab, of_b), scaled(ac, of_c))));
    const std::array<std::array<const Axis*, 2>, 3> edges = {{{&ab, &a}, {&ac, &a}, {&bc, &b}}};
    for (const auto& [edge, corner] : edges) {
      if (clear_) return;
      follow(cross(normal, *edge));
      if (clear_) return;
      follow(across(*corner, *edge));
    }
  }

  const NormalisedQuery& query_;
  ExclusionObserver* const observer_;
  const Differences differences_;
  const HeightErrorBound error_;
  double time_ = 0;      ///< separated until here
  double furthest_ = 0;  ///< and until here by an axis tried since
  bool clear_ = false;
  int tried_ = -1;  ///< number of the axis at hand
};

}  // namespace

Advancement advance(const NormalisedQuery& query, ExclusionObserver* observer) {
  return ConservativeAdvancement(query, observer).run();
}

std::array<Uv<double>, 2> nearest_parameters(const NormalisedQuery& query, double t) {
  const Differences differences(query);
  const Axis a = differences.at(0, t), b = differences.at(1, t), c = differences.at(2, t);
  std::array<Uv<double>, 2> uv{};
  const auto with_weights = [&](size_t s, const Uv<double>& at) {
    return parameters_with_weights(query.shapes[s], query.weights[s], at);
  };
  if (differences.is_face) {
    const auto side = static_cast<size_t>(differences.face_side);
    const auto [v, u] = nearest_of_face(a, b, c);
    uv[side] = inside_of_face(with_weights(side, {u, v}));
    return uv;
  }
  const std::array<double, 2> nearest = nearest_of_edges(a, minus(b, a), minus(a, c));
  for (size_t s = 0; s < 2; ++s) {
    if (query.shapes[s].kind == ShapeKind::kCurve) uv[s] = with_weights(s, {nearest[s], 0});
  }
  return uv;
}

}  // namespace ccdfuzz::certified
