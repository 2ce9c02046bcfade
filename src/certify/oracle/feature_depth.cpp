#include "certify/oracle/feature_depth.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "bezier/blossom.hpp"
#include "bezier/exact_patch.hpp"
#include "ccd/nearest_points.hpp"
#include "certify/linear/first_contact.hpp"
#include "certify/oracle/oracle.hpp"
#include "certify/oracle/rational_roots.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// Times t1 and t2 are taken so often between the contact and the ends of the time, each half as
/// far from it.
constexpr int kHalvings = 5;

using Corners = Points<Rational>;

/// The polygon of differences, corner by corner around it, at a time.
class Differences {
 public:
  explicit Differences(const Query& query) {
    const auto patches = linear::exact_patches(query);
    const auto& [a, b] = patches;
    const auto add = [&](size_t i, size_t j) {
      positions_.push_back(a.positions[i] - b.positions[j]);
      velocities_.push_back(a.velocity(i) - b.velocity(j));
    };
    if (a.positions.size() == 2 && b.positions.size() == 2) {
      for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) add(i, j);
    } else {
      for (size_t i = 0; i < a.positions.size(); ++i) {
        for (size_t j = 0; j < b.positions.size(); ++j) add(i, j);
      }
    }
  }

  size_t size() const { return positions_.size(); }

  Corners at(const Rational& t) const {
    Corners corners;
    for (size_t i = 0; i < size(); ++i) corners.push_back(positions_[i] + velocities_[i] * t);
    return corners;
  }

  /// Whether D has one root between the times, by its coefficients of Bernstein, and none at them.
  bool has_one_root(const Rational& from, const Rational& to) const {
    const Corners p = at(from), q = at(to);
    // The polar form of the determinant, in those of the corners at both times.
    const auto mixed = [&](int late) {
      Rational sum = 0;
      for (int which = 0; which < 8; ++which) {
        if ((which & 1) + (which >> 1 & 1) + (which >> 2) != late) continue;
        const auto corner = [&](size_t i) { return ((which >> i & 1) != 0 ? q : p)[i]; };
        sum += dot(corner(0), corner(1).cross(corner(2)));
      }
      return sgn(sum);
    };
    const std::array<int, 4> signs = {mixed(0), mixed(1), mixed(2), mixed(3)};
    if (signs[0] == 0 || signs[3] == 0) return false;
    int changes = 0, last = signs[0];
    for (const int sign : signs) {
      changes += sign == -last ? 1 : 0;
      last = sign != 0 ? sign : last;
    }
    return changes == 1;
  }

 private:
  Corners positions_, velocities_;
};

/// The square of a distance that the hull of some points keeps from the origin.
Rational squared_from_origin(const Corners& points) {
  NearestPoints nearest;
  return nearest({{0, 0, 0}}, points).squared;
}

/// The same of what the edges sweep in a time.
Rational squared_of_edges(const Corners& from, const Corners& to) {
  Rational least = -1;
  for (size_t i = 0; i < from.size(); ++i) {
    const size_t next = (i + 1) % from.size();
    const Rational squared = squared_from_origin({from[i], from[next], to[i], to[next]});
    if (least < 0 || squared < least) least = squared;
  }
  return least;
}

/// How much nearer than the separation the points of a witness come in [its time, until], or the
/// patches at `until`.
double depth_within_separation(const Query& query, const Witness& witness, const Rational& until) {
  const auto patches = linear::exact_patches(query);
  const auto gap_at = [&](const Rational& t) {
    return Vec3<Rational>(evaluate(patches[0], witness.uv[0], t) -
                          evaluate(patches[1], witness.uv[1], t));
  };
  const Vec3<Rational> from = gap_at(witness.t), way = gap_at(until) - from;
  const Rational length = dot(way, way);
  Rational share = length == 0 ? Rational(0) : Rational(-dot(from, way) / length);
  share = std::clamp(share, Rational(0), Rational(1));
  const Vec3<Rational> nearest = from + way * share;
  NearestPoints nearest_at_end;
  const Rational at_end = nearest_at_end(patches[0].at(until), patches[1].at(until)).squared;
  const Rational squared = std::min(Rational(dot(nearest, nearest)), at_end);
  return std::max(0.0, round_down(exact(query.separation) - root_above(squared)));
}

}  // namespace

double feature_depth(const Case& known, double until) {
  const Query& query = known.query;
  const auto& [witness, root] = std::pair(known.truth.witness, known.truth.contact_root);
  if (!is_decided_linearly(query) || (!witness && !root)) return 0;
  if (query.separation > 0) {
    if (!witness || witness->t <= 0 || witness->t >= exact(until)) return 0;
    Case touching;
    touching.query = query;
    touching.query.separation = 0;
    touching.truth = decide(touching.query).truth;
    return std::max(feature_depth(touching, until),
                    depth_within_separation(query, *witness, exact(until)));
  }
  const Differences differences(query);
  const Rational first = witness ? witness->t : root->from, last = witness ? witness->t : root->by;
  const Rational end = exact(until);
  if (differences.size() < 3 || first <= 0 || last >= end) return 0;

  std::vector<Rational> times;  // kHalvings before the contact, as many after it
  for (int k = 0; k < kHalvings; ++k) times.push_back(first - first * power_of_two(-k));
  for (int k = kHalvings; k-- > 0;) times.push_back(last + (end - last) * power_of_two(-k));
  std::vector<Rational> at, edges;  // squares of distances; edges[i]: from times[i] to the next
  for (size_t i = 0; i < times.size(); ++i) {
    const Corners corners = differences.at(times[i]);
    at.push_back(squared_from_origin(corners));
    if (i > 0) edges.push_back(squared_of_edges(differences.at(times[i - 1]), corners));
  }
  Rational best = 0;
  for (size_t i = 0; i < kHalvings; ++i) {
    for (size_t j = kHalvings; j < times.size(); ++j) {
      Rational least = std::min(at[i], at[j]);
      for (size_t k = i; k < j; ++k) least = std::min(least, edges[k]);
      if (least > best && differences.has_one_root(times[i], times[j])) best = least;
    }
  }
  // Over a root that is rounded up: at most the root.
  return best == 0 ? 0 : round_down(best / root_above(best));
}

}  // namespace ccdfuzz
