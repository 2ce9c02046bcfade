#include <cmath>
#include <utility>

#include "case/scale.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/build_tree.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/draw_patch.hpp"
#include "generators/round.hpp"
#include "method/method.hpp"
#include "properties/against_oracle.hpp"
#include "properties/answers.hpp"
#include "properties/draw_first_contact.hpp"
#include "properties/draw_linear.hpp"
#include "properties/query_kind.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Case draw_case_apart(Draw& d) {
  return draw_first_contact(d, true);
}

void check_not_early_apart(Draw& d) {
  const FirstContact drawn = draw_first_contact(d, true);
  constexpr SearchOptions kBrief = {kFinePrecision, 300, SearchOptions().max_bytes};
  claim_not_early(d.pick(miss_nothing()), drawn, d, kBrief);
}

/// A tree that proves a share of a distance is refused as a proof of all of it, also of patches
/// that are round.
void check_trees(Draw& d) {
  const bool is_round = d.coin();
  const ContactClass contact = d.pick(std::array{ContactClass::kVF, ContactClass::kFF});
  const Case drawn = is_round ? draw_round_case(contact, true, d) : draw_case_apart(d);
  const Rational& t = drawn.truth.witness->t;
  Query nearer = drawn.query;
  nearer.separation *= d.pick(std::array{0.0, 0.5, 1 - 0x1p-6, 1 - 0x1p-20});
  show(d, "query", drawn.query);
  show(d, "separation", nearer.separation);
  const auto tree = supposed(build_miss_tree(nearer, t, is_round ? 3000 : 1000));
  CLAIM(check_clearance(nearer, tree).has_value());
  CLAIM(!check_clearance(drawn.query, tree));
}

/// A plane at right angles to the way between two points, which come towards each other, is refused
/// iff the way is shorter than the separation. Its length is no rational number, mostly, and is
/// compared with that as well as 61 bits can tell.
void check_planes_of_points(Draw& d) {
  Query query;
  const Vec3<double> way = draw_integers(d, 31);
  const Rational squared = exact(way.squaredNorm());
  query.patches[0] = {Shape::point(), {way}, {-way}};
  query.patches[1] = {Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
  query.separation = d.nudged(way.norm(), 2);
  MovingPlane plane{0, {}, 0};
  const Rational length = d.dyadic(8, -3).rational();
  suppose(squared > 0 && length > 0);
  plane.normal = exact(way) * length;
  show(d, "query", query);
  show(d, "normal", plane.normal);
  const Rational least = exact(query.separation) * exact(query.separation);
  const bool is_accepted = check_plane(query, plane).has_value();
  CLAIM(!is_accepted || least <= squared);
  CLAIM(is_accepted || least * (1 + power_of_two(-60)) > squared);
}

/// Linear patches that are planted to come as near as the separation at t*, and farther apart
/// before, are decided so. A float more or less of the separation changes that.
void check_linear_clearances(Draw& d) {
  constexpr std::array kPoints = {Shape::point(), Shape::curve(1), Shape::triangle(1)};
  constexpr std::array kClasses = {ContactClass::kVV, ContactClass::kVE, ContactClass::kVF,
                                   ContactClass::kEE};
  GeneratorOptions options;
  options.family = Family::kSeparated;
  const std::size_t place = d.choose(kClasses.size() - 1);
  options.contact = kClasses[place];
  options.shapes = {Shape::point(), kPoints[place % kPoints.size()]};
  if (options.contact == ContactClass::kEE) options.shapes->fill(Shape::curve(1));
  if (options.contact == ContactClass::kVE && d.coin()) options.shapes->fill(Shape::curve(1));
  Case made = generate(options, d).value;
  Query& query = made.query;
  if (d.coin()) std::swap(query.patches[0], query.patches[1]);
  show(d, "case", made);
  const Rational& t = made.truth.witness->t;
  const auto is_clear = [&](const Rational& until, bool closed, double separation) {
    Query asked = query;
    asked.separation = separation;
    return check_linear_clearance(asked, {until, closed}).has_value();
  };
  const double separation = query.separation;
  CLAIM(is_clear(t, false, separation));
  CLAIM(!is_clear(t, true, separation));
  CLAIM(!is_clear(t + power_of_two(-40), false, separation));
  CLAIM(!is_clear(t, false, std::nextafter(separation, HUGE_VAL)));
  CLAIM(is_clear(t, true, std::nextafter(separation, 0)));
}

/// A point (t, −m − 2, m), and an edge along (1, t, 0) about the origin. The square of its distance
/// from the edge's line is m² + (t² + m + 2)² / (1 + t²) = (m + 2)² + (t² − m)² / (1 + t²). So they
/// come as near as m + 2 at t = √m alone. They also drift, on axes and in units of their own.
void check_grazes(Draw& d) {
  const int m = d.integer(1, 1000), off = d.integer(-1, 1);
  const int exponent = d.integer(-40, 40), length = 1 << d.integer(5, 7);
  const std::size_t first = d.below(3);
  const Vec3<double> drift = draw_integers(d, 9);
  const auto placed = [&](double x, double y, double z) {
    const std::array at = {x, y, z};
    Vec3<double> out;
    for (std::size_t k = 0; k < 3; ++k) out[static_cast<int>((first + k) % 3)] = at[k];
    return Vec3<double>(std::ldexp(1.0, exponent) * out);
  };
  const double n = length;
  Query query;
  query.patches[0] = {Shape::point(), {placed(0, -m - 2, m)}, {placed(1, 0, 0) + drift}};
  query.patches[1] = {Shape::curve(1),
                      {placed(-n, 0, 0), placed(n, 0, 0)},
                      {placed(0, -n, 0) + drift, placed(0, n, 0) + drift}};
  if (d.coin()) std::swap(query.patches[0], query.patches[1]);
  query.t_max = 32;
  query.separation = std::ldexp(m + 2, exponent);
  if (off != 0) query.separation = std::nextafter(query.separation, off > 0 ? HUGE_VAL : 0);
  show(d, "query", query);
  const Truth truth = decide(query).truth;
  CLAIM(truth.collides == (off >= 0));
  if (off < 0) return;
  const Rational &clear = *truth.clear_until, by = *truth.contact_by();
  CLAIM(clear * clear <= m && (off > 0 || by * by >= m));
  CLAIM(by - clear <= query.t_max * power_of_two(-64));
}

/// A hit is at the distance, as far as doubles tell, or with pops as far as cells do.
void claim_at_distance(const Query& query, double size, Draw& d) {
  const Answer answer = asked(d, "tdibm-c", query, {});
  constexpr std::uint64_t kFewPops = 300;
  if (answer.verdict == Verdict::kMiss) {
    CLAIM(decide_briefly(query, kFewPops).truth.collides != true);
  }
  if (answer.verdict != Verdict::kHit) return;
  // Bounds, and the last step of 2^-44 of the way, are well below 2^-24 of the size. Cells of the
  // precision 1e-4 are below 2^-10 of it.
  Query nearly = query;
  nearly.separation += size * (answer.pops == 0 ? 0x1p-24 : 0x1p-10);
  CLAIM(decide_briefly(nearly, kFewPops).truth.collides != false);
}

/// A hit on a linear query is a contact, and a miss is none, in both orders of the patches.
void check_linear_apart(Draw& d) {
  Query query = draw_linear_apart(d);
  const double size = largest_coordinate_at_ends(query);
  claim_at_distance(query, size, d);
  std::swap(query.patches[0], query.patches[1]);
  claim_at_distance(query, size, d);
}

}  // namespace

std::vector<Property> distances_claims() {
  constexpr auto kMeaning = "src/case/query.hpp";
  constexpr auto kCertified = "src/ccd/certified/DERIVATION.md, 8";
  constexpr auto kRational = "src/ccd/rational/exact_scene.hpp";
  std::vector<Property> claims = {
      {"separation.not_early",
       "A hit at a distance is no earlier than the width of its boxes explains", kMeaning,
       check_not_early_apart},
      {"separation.refuses_nearer",
       "A tree that proves a share of a distance, also of round patches, is no proof of all of it",
       "src/certify/checker/check_tree.hpp", check_trees},
      {"separation.planes_of_points",
       "A plane of two points is accepted iff they are no nearer than the separation, to 61 bits",
       "src/certify/checker/check_plane.hpp", check_planes_of_points},
      {"separation.linear_clearance",
       "Linear patches are decided to be clear up to the time at which they are planted to come as "
       "near as the separation, and no longer, to the last float of it",
       "src/certify/checker/check_linear.hpp", check_linear_clearances},
      {"separation.linear_grazes",
       "Linear patches that come as near as the separation at one time alone, mostly an irrational "
       "one, are in contact then, and not at a float less",
       "src/certify/oracle/decide_linear.hpp", check_grazes},
      {"tdibm-c.linear_apart", "A hit on a linear query is at that distance, and a miss is none",
       kCertified, check_linear_apart},
  };
  add_claims_of(claims, {"separation",
                         "apart",
                         "at a distance",
                         {{"tdibm-c", kCertified}, {"tdibm-rational", kRational}},
                         &Features::separation,
                         {Family::kApart, Family::kSeparated},
                         draw_case_apart});
  return claims;
}

}  // namespace ccdfuzz
