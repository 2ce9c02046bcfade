#include "certify/oracle/decide_turning.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/time_limit.hpp"
#include "case/scale.hpp"
#include "ccd/nearest_points.hpp"
#include "certify/checker/check_bodies.hpp"
#include "certify/checker/check_turning.hpp"
#include "certify/checker/work_done.hpp"
#include "certify/oracle/rational_roots.hpp"
#include "certify/oracle/turned_points.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// Contacts take about 10 to 80 tries.
constexpr std::uint64_t kMostTries = 400;
/// Points are rounded to this of the scene's size, so that numbers stay short. It leaves 80 bits
/// beyond those of the bracket, as many as make a point inside of a hull.
constexpr int kPointBits = 120;
/// Where points are not rational, so much is left for one to be inside of a hull: a body is made
/// smaller by this part of itself.
constexpr int kInsideBits = 80;

/// Whether not all points of a hull are in one plane, or in the plane z = 0 on one line.
bool has_inside(const MovingPatch<double>& hull, bool in_plane) {
  const Vec3<Rational> zero(0, 0, 0);
  Vec3<Rational> side = zero, normal = zero;  // both of the first points that span so much
  for (const Vec3<double>& p : hull.positions) {
    const Vec3<Rational> way = exact(p) - exact(hull.positions[0]);
    if (normal.dot(way) != 0) return true;
    if (side == zero) {
      side = way;
    } else if (normal == zero) {
      normal = cross(side, way);
    }
  }
  return in_plane && normal != zero;
}

bool turns_by_angle(const MovingPatch<double>& body) {
  return body.turn && body.turn->from.size() == 2;
}

class DecidingTurning {
 public:
  DecidingTurning(const Query& query, const OracleOptions& options)
      : query_(query), options_(options), t_max_(exact(query.t_max)) {
    reach_ = exact(query.separation);
    Rational size = power_of_two(-1000);
    for (const MovingPatch<double>& body : query.patches) {
      reach_ += exact(body.radius);
      for_each_coordinate(body, [&](double x) { size += abs(exact(x)); });
    }
    unit_ = power_below(size) * power_of_two(-kPointBits);
    const auto& known = options.known;
    if (known && known->t <= t_max_) late_ = known->t, witness_ = known;
  }

  Decision run() {
    try {
      if (!options_.apart_along || !add_plane(seen_along(0), seen_along(t_max_))) approach();
    } catch (const OutOfTime&) {
      out_.note = kOutOfTime;
    }
    if (spent_ > kMostWork) {
      out_.truth = {};
      out_.note = check_body_planes(query_, planes_).error().message();
      return std::move(out_);
    }
    if (!planes_.planes.empty()) out_.truth.clearance = planes_;
    conclude(query_, out_.truth);
    return std::move(out_);
  }

 private:
  /// What is seen at a time, rounded: nothing is proven by it.
  struct Sight {
    Rational t;
    std::optional<Vec3<Rational>> normal;  ///< about of length 1; none: they are in contact
    std::array<Rational, 2> heights;       ///< along it: the highest of patch 1, the lowest of 2
  };

  /// In units.
  std::array<Points<Integer>, 2> rounded_points(const Rational& t) const {
    const auto of = [&](size_t side) { return points_at(query_.patches[side], t).in_units(unit_); };
    return {of(0), of(1)};
  }

  Sight sight_at(const Rational& t) {
    ++out_.pops;
    TimeLimit::stop_if_late();
    Sight out{t, {}, {}};
    const std::array<Points<Integer>, 2> points = rounded_points(t);
    NearestPoints nearest;
    const NearestPoints::Found& found = nearest(points);
    const Rational reach = reach_ / unit_;
    if (found.squared <= reach * reach) return out;
    constexpr int kBits = 56;
    // The way is scaled exactly, since its square need not be within the range of doubles.
    const Rational size = power_below(abs(found.way[0]) + abs(found.way[1]) + abs(found.way[2]));
    const double length = std::sqrt(Rational(found.squared / (size * size)).get_d());
    Vec3<Rational> normal;
    for (int k = 0; k < 3; ++k) {
      const double part = Rational(found.way[k] / size).get_d() / length;
      normal[k] = exact(std::ldexp(std::round(std::ldexp(part, kBits)), -kBits));
    }
    look_along(normal, points, out);
    return out;
  }

  void look_along(const Vec3<Rational>& normal, const std::array<Points<Integer>, 2>& points,
                  Sight& out) const {
    const std::array<Fraction, 3> along = {normal[0], normal[1], normal[2]};
    const auto height = [&](const Vec3<Integer>& p) {
      Fraction sum = 0;
      for (size_t k = 0; k < 3; ++k) sum += along[k] * Dyadic(p[static_cast<int>(k)], 0);
      return sum;
    };
    Fraction highest = height(points[0][0]), lowest = height(points[1][0]);
    for (const Vec3<Integer>& p : points[0]) highest = std::max(highest, height(p));
    for (const Vec3<Integer>& p : points[1]) lowest = std::min(lowest, height(p));
    out.heights = {highest.rational() * unit_, lowest.rational() * unit_};
    out.normal = normal;
  }

  /// Along the direction that may keep them apart.
  Sight seen_along(const Rational& t) const {
    Sight out{t, {}, {}};
    look_along(*options_.apart_along, rounded_points(t), out);
    return out;
  }

  /// Whether a plane between them from one time to another is proven, and kept then.
  bool add_plane(const Sight& here, const Sight& there) {
    BodyPlanes::Plane plane{here.t, {}, {}, 0};
    const Rational length =
        root_above(std::max(dot(*here.normal, *here.normal), dot(*there.normal, *there.normal)));
    const Rational kept = reach_ * length;
    const auto spare = [&](const Sight& at) {
      return Rational(at.heights[1] - at.heights[0] - kept);
    };
    const Rational least = std::min(spare(here), spare(there));
    if (least <= 0) return false;
    // The gap takes between 1/16 and 1/2 of what is spare, and the offset half of the rest.
    const Rational grid = power_below(least) / 16, some = 4 * grid;
    plane.gap = rounded_down(kept + some, grid) + grid;
    for (const size_t end : {size_t{0}, size_t{1}}) {
      const Sight& at = end == 0 ? here : there;
      plane.normals[end] = *at.normal;
      plane.offsets[end] = rounded_down(at.heights[0] + (spare(at) - some - grid) / 2, grid);
    }
    const std::uint64_t before = work_done_here();
    if (!check_body_plane(query_, plane, there.t)) return false;
    spent_ += work_done_here() - before;
    planes_.planes.push_back(std::move(plane));
    planes_.until = there.t;
    return true;
  }

  void approach() {
    Sight here = sight_at(0);
    if (!here.normal) {
      witness_.reset();
      return say_contact(0);
    }
    // Above 0, all of the way but 2^-level is tried, else 2^level of half of it.
    int level = 1;
    std::uint64_t left = std::min(kMostTries, options_.max_pops);
    for (; left > 0 && level > -kTimeBits; --left) {
      const Rational way = late_.value_or(t_max_) - here.t;
      if (late_ && way <= *late_ * power_of_two(-kBracketBits)) return say_contact(*late_);
      Rational next = late_.value_or(t_max_);
      if (late_ || level <= 0) {
        const Rational part = way * power_of_two(level > 0 ? -level : level - 1);
        next = level > 0 ? Rational(next - part) : Rational(here.t + part);
        next = rounded_down(next, power_below(part) / 16);
      }
      Sight there = sight_at(next);
      if (!there.normal) {
        late_ = next;
        witness_.reset();
        level = 1;
      } else if (add_plane(here, there)) {
        here = std::move(there);
        if (!late_ && here.t == t_max_) return;
        level = level > 0 ? std::min(2 * level, kBracketBits + 2) : level + 1;
      } else if (witness_ && options_.wanted_clear && here.t >= *options_.wanted_clear) {
        break;
      } else {
        level = level > 1 ? level / 2 : level - 1;
      }
    }
    if (witness_) return say_contact(*late_);
    out_.note = "no plane between the bodies was found for some of the time; they may just touch";
  }

  /// A time near to t at which the points of a body that turns by cosine and sine are rational.
  /// It is the last one of a grid before t (ulps = 0), or the next.
  Rational rational_time(const BodyTurn& turn, const Rational& t, int ulps) const {
    std::array<Rational, 2> from, to, q;
    for (size_t i = 0; i < 2; ++i) {
      from[i] = exact(turn.from[i]);
      to[i] = exact(turn.to[i]);
      q[i] = (1 - t) * from[i] + t * to[i];
    }
    const Rational turned = abs(Rational(from[0] * to[1] - from[1] * to[0]));
    if (turned == 0 || t_max_ == 0) return t;
    const auto squared = [](const auto& v) { return Rational(v[0] * v[0] + v[1] * v[1]); };
    // q, or −q, is along (1 − k², 2k), k the tangent of half of its angle, where k is rational. It
    // changes at least at half of the least rate of the angle: |from × to| over the largest |q|².
    const Rational rate = turned / std::max(squared(from), squared(to));
    const Rational unit =
        power_below(rate) * power_below(t > 0 ? t : t_max_) * power_of_two(-kBracketBits - 8);
    const Rational length = root_above(squared(q));
    Rational k = q[0] < 0 ? Rational(-q[1] / (length - q[0])) : Rational(q[1] / (length + q[0]));
    k = rounded_down(k, unit) + ulps * unit;
    const Rational cosine = 1 - k * k, sine = 2 * k;
    const Rational before = from[0] * sine - from[1] * cosine;
    const Rational after = to[0] * sine - to[1] * cosine;
    return before == after ? t : Rational(before / (before - after));
  }

  /// Proof of contact at a time at which all points are rational.
  std::optional<Witness> exact_witness(const Rational& t) const {
    if (t < 0 || t > t_max_) return std::nullopt;
    const PointsAt first = points_at(query_.patches[0], t),
                   second = points_at(query_.patches[1], t);
    if (!first.are_exact || !second.are_exact) return std::nullopt;
    NearestPoints nearest;
    const NearestPoints::Found& found = nearest(first.rational(), second.rational());
    if (found.squared > reach_ * reach_) return std::nullopt;
    return Witness{t, {}, found.weights};
  }

  /// Proof of contact at any time: of the nearest points, or, where hulls overlap, of a point
  /// inside of one of them.
  std::optional<Witness> inside_witness(const Rational& t) const {
    const std::array<Points<Integer>, 2> in_units = rounded_points(t);
    std::array<Points<Rational>, 2> points;
    for (const size_t s : {size_t{0}, size_t{1}}) {
      for (const Vec3<Integer>& p : in_units[s]) points[s].push_back(p.cast<Rational>());
    }
    for (const size_t smaller : {size_t{2}, size_t{0}, size_t{1}}) {
      std::array<Points<Rational>, 2> tried = points;
      const Rational part = power_of_two(-kInsideBits);
      if (smaller < 2) {
        Vec3<Rational> middle(0, 0, 0);
        const auto count = static_cast<long>(points[smaller].size());
        for (const Vec3<Rational>& p : points[smaller]) middle += p;
        middle /= Rational(count);
        for (Vec3<Rational>& p : tried[smaller]) p += part * (middle - p);
      }
      NearestPoints nearest;
      Witness witness{t, {}, nearest(tried[0], tried[1]).weights};
      if (smaller < 2) {
        std::vector<Rational>& weights = witness.weights[smaller];
        const auto count = static_cast<long>(weights.size());
        for (Rational& w : weights) w = (1 - part) * w + part / count;
      }
      if (check_body_contact(query_, witness)) return witness;
    }
    return std::nullopt;
  }

  std::optional<Witness> witness_near(const Rational& t) const {
    if (const auto witness = exact_witness(t)) return witness;
    for (const MovingPatch<double>& body : query_.patches) {
      for (const int ulps : {0, 1}) {
        if (!turns_by_angle(body)) continue;
        if (const auto witness = exact_witness(rational_time(*body.turn, t, ulps))) return witness;
      }
    }
    if (const auto witness = inside_witness(t)) return witness;
    // It may be deep enough only a little later.
    return inside_witness(std::min(t_max_, Rational(t + t * power_of_two(-kBracketBits))));
  }

  void say_contact(const Rational& t) {
    if (!witness_) witness_ = witness_near(t);
    out_.truth.witness = witness_;
    if (witness_) return;
    const bool in_plane = is_in_plane(query_);
    const bool is_provable =
        reach_ > 0 || std::ranges::any_of(query_.patches, [&](const MovingPatch<double>& body) {
          return has_inside(body, in_plane);
        });
    out_.note = is_provable ? "the bodies are not seen to overlap by more than rounding"
                            : "at times at which turned points are not rational, an overlap is "
                              "proven only of bodies with a volume, an area in z = 0 or a radius";
  }

  const Query& query_;
  const OracleOptions& options_;
  const Rational t_max_;
  Rational reach_, unit_;
  BodyPlanes planes_;             ///< each was accepted by the checker
  std::uint64_t spent_ = 0;       ///< what it takes to check them all
  std::optional<Rational> late_;  ///< at this time they seem to be in contact
  std::optional<Witness> witness_;
  Decision out_;
};

}  // namespace

Decision decide_turning(const Query& query, const OracleOptions& options) {
  return DecidingTurning(query, options).run();
}

}  // namespace ccdfuzz
