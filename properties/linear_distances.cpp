#include <cmath>
#include <utility>

#include "ccd/nearest_points.hpp"
#include "ccd/nearest_regions.hpp"
#include "certify/checker/check_bodies.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/oracle/decide_bodies.hpp"
#include "generators/draw_trim.hpp"
#include "numeric/products.hpp"
#include "properties/answers.hpp"
#include "properties/draw_linear.hpp"
#include "properties/query_kind.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Multiples of 2^-50, so that sums below 8 are exact.
double to_grid(double x) {
  return std::ldexp(std::nearbyint(std::ldexp(x, 50)), -50);
}

Vec3<double> draw_vector(Draw& d, int exponent) {
  constexpr std::int64_t kMost = std::int64_t{1} << 40;
  Vec3<double> v;
  for (int k = 0; k < 3; ++k) {
    v[k] = to_grid(std::ldexp(d.integer(-kMost, kMost), exponent - 40));
  }
  return v;
}

/// The shortest way is 2^-kLeastNearness at least, and what it exceeds the separation by is more
/// than this part of the size.
constexpr int kLeastNearness = 38, kTold = 42;

/// Corners of two linear patches that come as near as `way`: at inner points, at ends, or past
/// these. Edges are up to 2^-52 from parallel.
std::array<Points<double>, 2> draw_corners(Draw& d, Vec3<double>& way) {
  const Vec3<double> e = draw_vector(d, 0), other = draw_vector(d, 0);
  const double factor = d.pick(std::array{1.0, -1.0, 0.5, -0.75});
  const int turned = d.integer(0, 52);
  const Vec3<double> f = factor * e + std::ldexp(1.0, -turned) * other;
  suppose(e.norm() > 0);
  way = d.coin() ? cross(e, other) : Vec3<double>(other - e * (dot(e, other) / dot(e, e)));
  suppose(way.norm() > 0);
  const int nearness = d.integer(1, kLeastNearness);
  way *= std::ldexp(1 / way.norm(), -nearness);
  if (d.coin()) way += draw_vector(d, -nearness);

  const int beyond = d.coin() ? 2 : 0;
  const double a = d.integer(-beyond, 8 + beyond) / 8.0;
  const double b = d.integer(-beyond, 8 + beyond) / 8.0;
  const Vec3<double> p = draw_vector(d, 0), q = p + way - a * e;
  switch (d.below(4)) {
    case 0:
      return {Points<double>{p}, {q, q + e}};
    case 1: {
      const Vec3<double> corner = q - b * f;
      return {Points<double>{p}, {corner, corner + e, corner + f}};
    }
    default:
      return {Points<double>{p - b * f, p + (1 - b) * f}, {q, q + e}};
  }
}

/// Two linear patches that near each other until t = 1, or move apart from t = 0 on. The corners of
/// each move alike, or each by itself. The separation is less than the way by 2^-most_less of it,
/// or more.
Query draw_near_miss(Draw& d, int most_less) {
  Vec3<double> way;
  const std::array<Points<double>, 2> corners = draw_corners(d, way);
  const bool turns = d.coin(), departs = d.coin();
  const int exponent = -d.integer(0, 40);
  const Vec3<double> common = d.coin() ? draw_vector(d, 0) : Vec3<double>(0, 0, 0);
  Query query;
  query.t_max = 1;
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    const std::size_t count = corners[s].size();
    patch.shape = linear_shape(count);
    Vec3<double> v(0, 0, 0);
    for (std::size_t i = 0; i < count; ++i) {
      if (turns || i == 0) v = draw_vector(d, exponent);
      if ((dot(v, way) < 0) == ((s == 0) != departs)) v = -v;
      patch.velocities.push_back(v + common);
      Vec3<double> p;
      for (int k = 0; k < 3; ++k) p[k] = to_grid(corners[s][i][k]);
      patch.positions.push_back(departs ? p : Vec3<double>(p - patch.velocities.back()));
    }
  }
  const int less = d.integer(1, most_less);
  query.separation = way.norm() * (1 - std::ldexp(1.0, -less));
  if (d.coin()) std::swap(query.patches[0], query.patches[1]);
  return query;
}

/// The corners at t as bodies at rest.
Query at_rest(Query query, double t) {
  for (MovingPatch<double>& patch : query.patches) {
    patch.positions = patch.at(t);
    patch.velocities = {{0, 0, 0}};
    patch.shape = Shape::hull(static_cast<int>(patch.positions.size()));
  }
  return query;
}

/// One direction keeps the patches farther apart than the separation at t = 0 and at t = 1, hence
/// between: the gap along it is convex.
bool are_apart(const Query& query) {
  for (const double t : {0.0, 1.0}) {
    const Truth truth = decide_bodies(at_rest(query, t), {}).truth;
    if (truth.collides != false) return false;
    const auto& clear = std::get<BodyClearance>(*truth.clearance);
    if (check_body_clearance(at_rest(query, 1 - t), clear)) return true;
  }
  return false;
}

void check_near_misses(Draw& d) {
  const Query query = draw_near_miss(d, kTold);
  suppose(is_valid(query));
  Query farther = query;
  farther.separation += std::ldexp(1.0, -kTold);
  suppose(are_apart(farther));
  CLAIM(check_linear_clearance(farther, {1, true}).has_value());
  const Answer answer = asked(d, "tdibm-c", query, {});
  CLAIM(answer.verdict == Verdict::kMiss || answer.pops > 0);
}

/// Convex polygons in the domain of a patch.
using Pieces = std::vector<std::vector<Uv<double>>>;

/// A trim whose region leaves out the middle of a triangle: domains at its corners, or a ring. And
/// that region in pieces.
Pieces draw_pieces(Draw& d, Trim& trim) {
  const Shape shape = Shape::triangle(1);
  const int halvings = d.integer(1, 4);
  if (d.coin()) {
    const Uv<double> centre = {d.integer(1, 4) / 8.0, d.integer(1, 3) / 8.0};
    trim = {loop_about(shape, {0, 0}, 0), loop_about(shape, centre, halvings)};
    Pieces pieces;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      pieces.push_back({trim[0][k], trim[0][next], trim[1][k], trim[1][next]});
    }
    return pieces;
  }
  constexpr std::array<Uv<double>, 3> kCorners = {{{0, 0}, {1, 0}, {0, 1}}};
  const std::size_t first = d.below(3);
  for (std::size_t k = 0, count = 1 + d.below(3); k < count; ++k) {
    trim.push_back(loop_about(shape, kCorners[(first + k) % 3], halvings));
  }
  return trim;
}

/// Gives linear patches weights and triangles trims, or leaves them as they are; what is left.
std::array<Pieces, 2> draw_regions(Draw& d, Query& query) {
  std::array<Pieces, 2> regions;
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    if (d.coin()) patch.weights = draw_patch_weights(d, patch.positions.size());
    regions[s] = {{{0, 0}, {1, 0}, {0, 1}}};
    regions[s][0].resize(patch.positions.size());
    if (patch.shape.parameter_count() == 2 && d.coin()) regions[s] = draw_pieces(d, patch.trim);
  }
  return regions;
}

Rational squared_distance(const Query& query, const std::array<Pieces, 2>& regions,
                          const Rational& t) {
  std::optional<Rational> least;
  const auto image = [&](std::size_t s, const std::vector<Uv<double>>& piece) {
    Points<Rational> out;
    for (const Uv<double>& uv : piece) {
      out.push_back(point_of(query.patches[s], {exact(uv[0]), exact(uv[1])}, t));
    }
    return out;
  };
  for (const auto& a : regions[0]) {
    for (const auto& b : regions[1]) {
      const Rational squared = NearestPoints()(image(0, a), image(1, b)).squared;
      if (!least || squared < *least) least = squared;
    }
  }
  return *least;
}

/// A triangle, and beside it one or an edge or point, whose first corner is near some point of the
/// triangle.
void check_distance_of_regions(Draw& d) {
  Query query;
  for (MovingPatch<double>& patch : query.patches) {
    patch.shape = linear_shape(&patch == &query.patches[0] ? 3 : 1 + d.below(3));
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      patch.positions.push_back(draw_vector(d, 0));
    }
    patch.velocities.assign(patch.positions.size(), {0, 0, 0});
  }
  std::array<Pieces, 2> regions = draw_regions(d, query);
  const int i = d.integer(0, 8), j = d.integer(0, 8 - i);
  const auto near = point_of(query.patches[0], {Rational(i) / 8, Rational(j) / 8}, 0);
  Vec3<double> shift = draw_vector(d, -d.integer(0, 8)) - query.patches[1].positions[0];
  for (int k = 0; k < 3; ++k) shift[k] += near[k].get_d();
  for (Vec3<double>& p : query.patches[1].positions) p += shift;
  if (d.coin()) {
    std::swap(query.patches[0], query.patches[1]);
    std::swap(regions[0], regions[1]);
  }
  CLAIM(squared_distance_of_regions(query, 0) == squared_distance(query, regions, 0));
}

/// Two linear patches that start just farther apart than the separation, or as near where one is
/// trimmed, and near each other then.
void check_toi_after_start(Draw& d) {
  constexpr int kOneUlp = 53;
  Query query = draw_near_miss(d, kOneUlp);
  for (MovingPatch<double>& patch : query.patches) {
    for (Vec3<double>& v : patch.velocities) v = -v;
  }
  const std::array<Pieces, 2> regions = draw_regions(d, query);
  const Rational start = squared_distance(query, regions, 0);
  if (is_trimmed(query)) {
    const double off = std::ldexp(d.coin() ? 1.0 : -1.0, -d.integer(1, kOneUlp));
    query.separation = std::sqrt(start.get_d()) * (1 + off);
  }
  suppose(is_valid(query));
  const Rational squared = exact(query.separation) * exact(query.separation);
  const std::string method = d.pick(every_method_but({}, &MethodInfo::claim_is_proven));
  const Answer answer = asked(d, method, query, {.max_pops = 1000});
  CLAIM(start > squared || answer.verdict != Verdict::kMiss);
  if (answer.verdict != Verdict::kHit) return;
  CLAIM((*answer.toi > 0) == (start > squared));
  CLAIM(start <= squared || squared_distance(query, regions, exact(*answer.toi)) >= squared);
}

}  // namespace

std::vector<Property> linear_distances_claims() {
  return {{"linear.toi_after_start",
           "A hit on linear patches, or the regions of their trims, is later than t = 0 iff they "
           "start farther apart than the separation, and no later than they are that near",
           "src/ccd/past_start.hpp", check_toi_after_start},
          {"linear.distance_of_regions",
           "The distance of the regions of trimmed linear patches is that of their pieces",
           "src/ccd/nearest_regions.hpp", check_distance_of_regions},
          {"tdibm-c.linear_near_misses",
           "Linear patches that stay farther apart than the separation, by 2^-42 of their largest "
           "coordinate between 0 and t_max, are no hit without pops",
           "src/ccd/certified/DERIVATION.md, 8", check_near_misses}};
}

}  // namespace ccdfuzz
