#include "ccd/witness_trace/trace.hpp"
#include "certify/checker/check_box.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_trim.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/oracle/build_tree.hpp"
#include "certify/oracle/find_contact.hpp"
#include "certify/oracle/oracle.hpp"
#include "fuzz/mutator/moves.hpp"
#include "generators/draw_patch.hpp"
#include "generators/draw_trim.hpp"
#include "method/method.hpp"
#include "properties/answers.hpp"
#include "properties/draw_first_contact.hpp"
#include "properties/draw_trimmed.hpp"
#include "properties/query_kind.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// A trim of all of the domain is none, to each method that has no linear decision.
void check_trim_whole(Draw& d) {
  const Case plain = supposed(draw_contact(d, {-2, 2, 3}));
  Query trimmed = plain.query;
  for (MovingPatch<double>& patch : trimmed.patches) {
    if (patch.shape.parameter_count() != 2) continue;
    patch.trim = {loop_about(patch.shape, {0, 0}, 0)};
  }
  suppose(is_trimmed(trimmed));
  show(d, "query", trimmed);
  claim_answered_alike(every_method_but({"tdibm-c", "oracle"}), trimmed, plain.query, kQuickSearch);
}

/// Each method drops a pair of cells that holds a contact of the region only if it does so of the
/// whole patches.
void check_trim_traces(Draw& d) {
  const Case known = show(d, "contact", draw_trimmed_contact(d));
  Query whole = known.query;
  for (MovingPatch<double>& patch : whole.patches) patch.trim.clear();
  for (const std::string method : {"tdibm", "tdibm-e", "trad", "tdibm-rational", "tdibm-c"}) {
    // Its trace of whole linear patches is that of the linear decision.
    if (method == "tdibm-c" && is_linear_query(whole)) continue;
    const auto made = make_method(method).value();
    const TraceOptions options{.precision = 0x1p-8, .all = true};
    const Witness& witness = *known.truth.witness;
    const Trace& trimmed = made->trace(known.query, witness, options);
    const auto seen = std::array{trimmed.pairs, trimmed.lost_pairs};
    const Trace& of_whole = made->trace(whole, witness, options);
    CLAIM(seen == std::array{of_whole.pairs, of_whole.lost_pairs});
  }
}

/// Asks a method. The cells of a hit are not outside: within their width of its parameters is a
/// point of the region.
Verdict verdict_near_regions(Draw& d, const Query& query, const std::string& method) {
  const Answer answer = asked(d, method, query, kQuickSearch);
  show(d, "uv", answer.uv);
  if (answer.verdict != Verdict::kHit) return answer.verdict;
  for (std::size_t s = 0; s < 2; ++s) {
    const Uv<Rational> at = exact_place(answer.uv[s]);
    const Rational width = exact(kQuickSearch.precision);
    const std::vector<Uv<Rational>> square = {{at[0] - width, at[1] - width},
                                              {at[0] + width, at[1] - width},
                                              {at[0] + width, at[1] + width},
                                              {at[0] - width, at[1] + width}};
    Work work(kMostWork);
    CLAIM(region_of(query.patches[s].trim, square, work) != Region::kOutside);
  }
  return answer.verdict;
}

void check_trim_hits(Draw& d) {
  const Case known = draw_trimmed(d);
  show(d, "query", known.query);
  for (const std::string method : {"tdibm-c", "tdibm-rational", "tdibm"}) {
    verdict_near_regions(d, known.query, method);
  }
}

const OracleOptions kLittle{.max_pops = 300, .max_tree_nodes = 1000};

/// A point meets the plane of a trimmed triangle at a place that counts or does not.
void check_trim_linear(Draw& d) {
  Query query;
  auto& [point, surface] = query.patches;
  const Uv<Dyadic> place = draw_uv(d, Shape::triangle(1), 4);
  const Uv<double> at = {*place[0].to_double_exactly(), *place[1].to_double_exactly()};
  surface = {Shape::triangle(1), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {}};
  surface.velocities.resize(3, Vec3<double>(0, 0, 0));
  surface.trim = draw_trim(d, surface.shape, at);
  point = {Shape::point(), {{at[0], at[1], 0.5}}, {{0, 0, -1}}};
  show(d, "query", query);
  const bool counts = is_in_region(surface.trim, exact_place(at));
  CLAIM(decide(query, kLittle).truth.collides != !counts);
  const Verdict verdict = verdict_near_regions(d, query, "tdibm-c");
  CLAIM(!counts || verdict != Verdict::kMiss);
}

/// A first contact is in a hole, at t_max, and nowhere else. The whole patches touch, and the
/// trimmed ones are proven not to. That proof is refused for the whole ones.
void check_trim_hole(Draw& d) {
  const FirstContact drawn = draw_first_contact(d);
  Query whole = drawn.query;
  const Witness& witness = *drawn.truth.witness;
  whole.t_max = witness.t.get_d();
  Query trimmed = whole;
  const std::size_t side = d.choose(1);
  MovingPatch<double>& patch = trimmed.patches[side];
  suppose(patch.shape.parameter_count() == 2);
  const Uv<Rational>& at = witness.uv[side];
  const int halvings = 1 + static_cast<int>(d.choose(2));
  patch.trim = {loop_about(patch.shape, {0, 0}, 0),
                loop_about(patch.shape, {at[0].get_d(), at[1].get_d()}, halvings)};
  suppose(is_valid(trimmed) && !is_in_region(patch.trim, at));
  show(d, "query", trimmed);
  CLAIM(check_witness(whole, witness).has_value());
  CLAIM(!check_witness(trimmed, witness));
  constexpr std::uint64_t kNodes = 4000;
  const auto tree = supposed(build_miss_tree(trimmed, exact(whole.t_max), kNodes));
  CLAIM(check_clearance(trimmed, tree).has_value());
  CLAIM(!check_clearance(whole, tree));
  Query filled = trimmed;
  filled.patches[side].trim.pop_back();
  CLAIM(!check_clearance(filled, tree));
}

/// A contact box of whole patches, one of which is a surface: its side and its radius there.
struct DrawnBox {
  Query query;
  ContactBox box;
  std::size_t side = 0;
  std::array<double, 2> radius{};  ///< the one of that side's parameters
};

DrawnBox draw_box(Draw& d) {
  const Case known = d.coin() ? Case(draw_first_contact(d)) : supposed(draw_contact(d, {-2, 2, 2}));
  const Witness& witness = *known.truth.witness;
  DrawnBox out;
  out.query = known.query;
  ContactGuess guess{{}, round_down(witness.t), 0x1p-20};
  for (std::size_t s = 0; s < 2; ++s) {
    guess.uv[s] = {witness.uv[s][0].get_d(), witness.uv[s][1].get_d()};
  }
  out.box = supposed(find_contact_box(out.query, guess));
  out.side = d.choose(1);
  suppose(out.query.patches[out.side].shape.parameter_count() == 2);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto place = static_cast<std::size_t>(out.box.varied[i]);
    if (place / 2 == out.side) out.radius[place % 2] = out.box.radius[i];
  }
  return out;
}

/// A box that is accepted has its corners in the region, and no vertex of a loop inside.
void check_trim_boxes(Draw& d) {
  auto [query, box, side, radius] = draw_box(d);
  MovingPatch<double>& patch = query.patches[side];
  const std::array<double, 2> centre = {box.centre[2 * side], box.centre[2 * side + 1]};
  const auto z = static_cast<std::size_t>(box.dependent[side]);
  const auto place = [&](const Rational& a, const Rational& b) -> Uv<Rational> {
    std::array<Rational, 3> barycentrics;
    barycentrics[z] = 1 - a - b;
    barycentrics[(z + 1) % 3] = a;
    barycentrics[(z + 2) % 3] = b;
    return {barycentrics[1], barycentrics[2]};
  };
  const Uv<Rational> at = place(exact(centre[0]), exact(centre[1]));
  // Loops as large as the box, too.
  patch.trim = {
      loop_about(patch.shape, {0, 0}, 0),
      loop_about(patch.shape, {at[0].get_d(), at[1].get_d()}, static_cast<int>(d.choose(48)))};
  if (d.coin()) patch.trim.erase(patch.trim.begin());
  if (d.coin()) {
    patch.trim.back() = draw_loop_through(d, patch.shape, {at[0].get_d(), at[1].get_d()}, false);
  }
  if (d.coin()) {
    for (auto& vertex : patch.trim.back())
      vertex[0] += static_cast<double>(d.choose(2)) * radius[0];
  }
  suppose(is_valid(query));
  show(d, "query", query);
  show(d, "radius", radius);
  show(d, "centre", centre);
  if (!check_box(query, box)) return;
  for (const int i : {-1, 0, 1}) {
    for (const int j : {-1, 0, 1}) {
      CLAIM(is_in_region(patch.trim, place(exact(centre[0]) + i * exact(radius[0]),
                                           exact(centre[1]) + j * exact(radius[1]))));
    }
  }
  if (radius[0] == 0 || radius[1] == 0) return;
  for (const auto& loop : patch.trim) {
    for (const Uv<double>& vertex : loop) {
      const Uv<Rational> uv = exact_place(vertex);
      const std::array<Rational, 3> barycentrics = {Rational(1 - uv[0] - uv[1]), uv[0], uv[1]};
      const bool is_beside = abs(barycentrics[(z + 1) % 3] - exact(centre[0])) > exact(radius[0]) ||
                             abs(barycentrics[(z + 2) % 3] - exact(centre[1])) > exact(radius[1]);
      CLAIM(is_beside);
    }
  }
}

/// A mutant of loops is a contact of a valid query.
void check_trim_moves(Draw& d) {
  Contact q = supposed(
      contact_of(d.coin() ? draw_trimmed_contact(d) : supposed(draw_contact(d, {-2, 2, 3}))));
  for (std::uint64_t left = 1 + d.choose(4); left > 0; --left) {
    if (Contact next = q; change_trim(next, d)) q = std::move(next);
  }
  const Case known = show(d, "mutant", case_of(q));
  CLAIM(check_truth(known).has_value());
}

}  // namespace

std::vector<Property> trimmed_queries_claims() {
  constexpr auto kDomain = "src/bezier/trim_region.hpp";
  constexpr auto kChecker = "src/case/certificate.hpp";
  constexpr auto kCertified = "src/ccd/certified/tdibm_c.hpp";
  constexpr auto kRational = "src/ccd/rational/tdibm_rational.hpp";
  std::vector<Property> claims = {
      {"trims.whole_is_none", "A trim of all of the domain changes no bit of an answer", kDomain,
       check_trim_whole},
      {"trims.traces", "A contact in the region is followed as that of the whole patches", kDomain,
       check_trim_traces},
      {"trims.hits", "A hit's parameters are within the precision of the region", kCertified,
       check_trim_hits},
      {"trims.linear", "A point meets a trimmed triangle iff it comes to the region of its trim",
       kCertified, check_trim_linear},
      {"trims.hole", "A contact in a hole is none, by a proof that is none of the whole patch",
       kChecker, check_trim_hole},
      {"checker.refuses_boxes_outside", "No box that leaves a trim holds a contact", kChecker,
       check_trim_boxes},
      {"mutator.keeps_trims", "Changed loops are valid, and the contact is in their region",
       "fuzz/mutator/moves.hpp", check_trim_moves},
  };
  add_claims_of(claims, {"trims",
                         "trimmed",
                         "of trimmed patches",
                         {{"tdibm-c", kCertified}, {"tdibm-rational", kRational}},
                         &Features::trims,
                         {Family::kTrimmed, Family::kTrimmed},
                         draw_trimmed});
  return claims;
}

}  // namespace ccdfuzz
