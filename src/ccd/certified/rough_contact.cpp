#include "ccd/certified/rough_contact.hpp"

#include <algorithm>
#include <cmath>

#include "ccd/certified/guess_root.hpp"
#include "ccd/certified/linear_differences.hpp"

namespace ccdfuzz::certified {

namespace {

using Found = RoughContact::Kind;

/// Windows looked at before integers take over: these take as long.
constexpr int kMostWindows = 16;
/// The least window about a root, as a part of t_max: the step of times that integers find.
constexpr double kShortest = 0x1p-44;
/// Where a window of two roots or none is split. Not in the middle, where scenes made by hand have
/// their contacts.
constexpr double kSplit = 0.46875;

/// Component k of a × b.
double cross_component(const Axis& a, const Axis& b, std::size_t k) {
  const std::size_t y = (k + 1) % 3, z = (k + 2) % 3;
  return a[y] * b[z] - a[z] * b[y];
}

std::size_t largest_component(const Axis& a) {
  std::size_t k = std::abs(a[1]) > std::abs(a[0]) ? 1 : 0;
  return std::abs(a[2]) > std::abs(a[k]) ? 2 : k;
}

/// 1 or −1 where all are beyond the bound on that side, otherwise 0.
template <class... Values>
int sign_beyond(double bound, Values... values) {
  const bool above = ((values > bound) & ...), below = ((values < -bound) & ...);
  return above - below;
}

class RoughSearch {
 public:
  RoughSearch(const NormalisedQuery& query, double width)
      : differences_(query),
        of_corner_((5 + query.roundings) * (0x1p-53 * query.magnitude + query.absolute)),
        shortest_(kShortest * query.t_max),
        width_(width) {}

  RoughContact run(double from, double first, double to) {
    const Found kind = decide_parts(instant_at(from), first, instant_at(to));
    return {kind, time_};
  }

 private:
  /// Corners in the order of a polygon; a triangle has its last one twice.
  using Corners = std::array<Axis, 4>;
  struct Instant {
    double t;
    Corners corners;
  };

  static double largest_coordinate(const Corners& corners) {
    Axis m{};
    for (const Axis& corner : corners) {
      for (std::size_t k = 0; k < 3; ++k) m[k] = std::max(m[k], std::abs(corner[k]));
    }
    return std::max({m[0], m[1], m[2]});
  }

  Instant instant_at(double t) const {
    constexpr std::array<std::array<int, 4>, 2> kOrders = {{{0, 1, 3, 2}, {0, 1, 2, 2}}};
    Instant out{t, {}};
    for (std::size_t i = 0; i < 4; ++i) {
      out.corners[i] = differences_.at(kOrders[differences_.is_face ? 1 : 0][i], t);
    }
    return out;
  }

  /// What is found in the times from a to b. Sets time_ where a contact is proven.
  Found decide(const Instant& a, const Instant& b);
  /// Decides both parts, one after the other, or all of it where the split is not inside.
  Found decide_parts(const Instant& a, double split, const Instant& b) {
    if (!(a.t < split && split < b.t)) return decide(a, b);
    const Instant middle = instant_at(split);
    const Found kind = decide(a, middle);
    return kind == Found::kNone ? decide(middle, b) : kind;
  }

  const Differences differences_;
  const double of_corner_;  ///< error of a coordinate
  const double shortest_, width_;
  int windows_ = 0;
  double time_ = 0;
};

Found RoughSearch::decide(const Instant& a, const Instant& b) {
  if (++windows_ > kMostWindows) return Found::kOpen;
  const Corners &p = a.corners, &q = b.corners;
  const double m = std::max(largest_coordinate(p), largest_coordinate(q));
  if (!(of_corner_ < 0x1p-20 * m)) return Found::kOpen;
  // Law L9: these bound the errors of a cross product and of a determinant.
  const double of_cross = 6 * m * of_corner_, of_determinant = 96 * m * m * of_corner_;

  // The determinant's coefficients in Bernstein's basis, those inside three times.
  const Axis before = cross(p[1], p[2]), after = cross(q[1], q[2]);
  const Axis mixed = plus(cross(p[1], q[2]), cross(q[1], p[2]));
  const double d0 = dot(p[0], before), d1 = dot(q[0], before) + dot(p[0], mixed),
               d2 = dot(p[0], after) + dot(q[0], mixed), d3 = dot(q[0], after);
  if (sign_beyond(of_determinant, d0, d1, d2, d3) != 0) return Found::kNone;

  const int at_start = sign_beyond(of_determinant, d0), at_end = sign_beyond(of_determinant, d3);
  if (at_start == 0 || at_end == 0) return Found::kOpen;

  // The crosses of neighbours in one component, by their coefficients, the middle one twice.
  const std::size_t k = largest_component(cross(minus(p[1], p[0]), minus(p[2], p[0])));
  int above = 0, below = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    if (differences_.is_face && i == 2) continue;
    const double middle = cross_component(p[i], q[j], k) + cross_component(q[i], p[j], k);
    const int sign = sign_beyond(of_cross, cross_component(p[i], p[j], k),
                                 cross_component(q[i], q[j], k), 0.5 * middle);
    above += sign > 0;
    below += sign < 0;
  }
  if (above > 0 && below > 0) return Found::kNone;

  if (at_start == at_end) return decide_parts(a, a.t + kSplit * (b.t - a.t), b);
  if (std::max(above, below) == differences_.count && b.t <= a.t + width_) {
    time_ = a.t;
    return Found::kProven;
  }
  const double length = b.t - a.t;
  // A window about a root, as narrow as doubles tell that the sign changes in it.
  const std::array<double, 4> powers = {d0, d1 - 3 * d0, 3 * d0 - 2 * d1 + d2, d3 - d0 + d1 - d2};
  const double x = guess_root(powers);
  const double slope = std::abs(powers[1] + x * (2 * powers[2] + x * 3 * powers[3]));
  const double reach = std::max(0.5 * shortest_, 2 * of_determinant / slope * length);
  if (!(reach < 0.25 * length)) return Found::kOpen;
  const double root = a.t + x * length;
  const Instant lo = instant_at(std::max(a.t, root - reach)),
                hi = instant_at(std::min(b.t, root + reach));
  // First where it may stay open.
  const Found about = decide(lo, hi);
  if (about == Found::kOpen) return about;
  const double time = time_;
  const Found so_far = decide(a, lo);
  if (so_far != Found::kNone) return so_far;
  time_ = time;
  return about == Found::kNone ? decide(hi, b) : about;
}

}  // namespace

RoughContact rough_contact(const NormalisedQuery& query, double from, double first, double width) {
  // Three corners at least: of fewer, all are in a plane with the origin.
  if (query.controls[0].size() + query.controls[1].size() < 4) return {};
  return RoughSearch(query, width).run(from, first, query.t_max);
}

}  // namespace ccdfuzz::certified
