#include <cmath>

#include "generators/draw_patch.hpp"
#include "method/method.hpp"
#include "properties/against_oracle.hpp"
#include "properties/answers.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Budgets that no drawn query makes long.
constexpr SearchOptions kShortSearch = {0x1p-4, 60, SearchOptions().max_bytes};

void check_no_state(Draw& d) {
  const std::string name = show(d, "method", draw_spec(d, every_method_but()));
  const Result<Case> first = draw_contact(d, {}), second = draw_contact(d, {});
  suppose(first && second);
  const auto used = *make_method(name), fresh = *make_method(name);
  const Answer expected = fresh->answer(first->query, kShortSearch);
  used->answer(second->query, kShortSearch);
  show(d, "asked", *first);
  show(d, "asked before", *second);
  claim_same(used->answer(first->query, kShortSearch), expected);
  claim_same(fresh->answer(first->query, kShortSearch), expected);
}

/// About a contact of ordinary numbers: the second patch is lifted by up to 2^-3 of a unit, so that
/// no contact is known.
Query draw_lifted(Draw& choices) {
  Query query = supposed(draw_contact(choices, {-2, 2, 2})).query;
  for (Vec3<double>& p : query.patches[1].positions) {
    p[2] += std::ldexp(choices.integer(-8, 8), -6);
  }
  return query;
}

void check_agree_anywhere(Draw& d) {
  constexpr std::uint64_t kPops = 12, kMorePops = 200;
  if (d.choose(3) == 3) return claim_all_agree(draw_lifted(d), kMorePops, kShortSearch);
  Query query = draw_any_query(d);
  // Numbers of one size touch more often than those of any.
  if (d.coin()) {
    for (MovingPatch<double>& patch : query.patches) {
      for_each_coordinate(patch, [&](double& x) { x = d.integer(-4, 4); });
    }
    query.t_max = d.integer(0, 4);
    // Their first corners meet, at a time of which they need not say so.
    if (d.coin()) {
      const double t = d.integer(0, 4);
      auto& [a, b] = query.patches;
      b.positions[0] = a.positions[0] + (a.velocities[0] - b.velocities[0]) * t;
    }
  }
  claim_all_agree(query, kPops, kRefutationSearch);
}

constexpr std::array kWindowed = {"tdibm",   "tdibm-h:1e-12",   "tdibm-h:1e-12@absolute",
                                  "tdibm-e", "tdibm-e-literal", "tdibm-rational",
                                  "tdibm-c"};
constexpr SearchOptions kCoarseSearch = {0.5, 60, SearchOptions().max_bytes};

/// Asked up to t1 ≤ t2, a hit up to t1 and a miss up to t2 do not go together.
void claim_monotone_in_t_max(Draw& d, const char* name) {
  const Query longer = show(d, "query", draw_lifted(d));
  Query shorter = longer;
  shorter.t_max *= std::ldexp(d.integer(0, 16), -4);
  const Answer early = answer_of(name, shorter, kCoarseSearch);
  const Answer late = answer_of(name, longer, kCoarseSearch);
  show(d, "method", name);
  show(d, "t1", shorter.t_max);
  CLAIM(early.verdict != Verdict::kHit || late.verdict != Verdict::kMiss);
}

/// Patches within 2^3 of their places, which are 2^7 apart along an axis, at speeds of less than 2:
/// a method says that they do not touch. One that always hits, or never decides, does not. Oriented
/// boxes have no axes where a surface is but a point, so most methods are asked about points.
void check_far_apart(Draw& d) {
  const std::string name = draw_spec(d, every_method_but());
  const bool takes_anything = name == "tdibm-c" || name == "trad:aabb";
  Query query = draw_small_query(d, takes_anything ? 2 : 0);
  query.t_max = 2;
  const auto along = static_cast<int>(d.choose(2));
  for (Vec3<double>& p : query.patches[1].positions) p[along] += 128;
  CLAIM(asked(d, name, query, kQuickSearch).verdict == Verdict::kMiss);
}

/// Two points meet: a method that claims to miss nothing says hit, and neither misses nor gives up.
void check_meeting_points(Draw& d) {
  const std::string name = d.pick(every_method_but({}, &MethodInfo::claims_no_false_negative));
  const double t = show(d, "t", std::ldexp(d.integer(0, 8), -3));
  const Vec3<double> meeting = draw_integers(d, 64);
  Query query;
  for (MovingPatch<double>& patch : query.patches) {
    patch.shape = Shape::point();
    const Vec3<double> v = draw_integers(d, 64);
    patch.velocities = {v};
    patch.positions = {Vec3<double>(meeting - v * t)};
  }
  const Answer answer = asked(d, name, query, kQuickSearch);
  CLAIM(answer.verdict == Verdict::kHit);
  CLAIM(*answer.toi <= t);
}

/// The claim of tdibm-e-literal is false, which one of its own says.
void check_no_false_negative(Draw& d) {
  const std::string name =
      d.pick(every_method_but({"tdibm-e-literal"}, &MethodInfo::claims_no_false_negative));
  claim_no_false_negative(name, draw_transformed(d), kQuickSearch, d);
}

}  // namespace

std::vector<Property> method_answers_claims() {
  return {
      {"methods.no_false_negative",
       "No method that claims to miss nothing misses a contact of ordinary numbers or is late; but "
       "tdibm-e-literal does",
       "src/method/method.hpp", check_no_false_negative},
      {"methods.no_state", "A method answers as a fresh one does, whatever it was asked before",
       "src/method/method.hpp", check_no_state},
      {"methods.not_contradicted_anywhere",
       "No claim to miss nothing is contradicted by the oracle near contacts or on any finite "
       "numbers in any two shapes, and the checker accepts the oracle there",
       "src/certify/oracle/oracle.hpp", check_agree_anywhere},
      {"methods.monotone_in_t_max",
       "No method that narrows its windows hits up to a time and misses up to a later one; but two "
       "patches within the precision may be hit by other windows, and not by these",
       "Section 3", [](Draw& d) { claim_monotone_in_t_max(d, d.pick(kWindowed)); }, kFails},
      {"trad.monotone_in_t_max",
       "No method that halves its windows hits up to a time and misses up to a later one; but what "
       "is narrow depends on t_max",
       "Section 6 (1)", [](Draw& d) { claim_monotone_in_t_max(d, d.pick(std::array{"trad"})); },
       kFails},
      {"methods.miss_what_is_far_apart", "Every method says of patches far apart that they miss",
       "Section 3", check_far_apart},
      {"methods.hit_where_points_meet", "Methods that claim to miss nothing hit where points meet",
       "Section 3", check_meeting_points},
  };
}

}  // namespace ccdfuzz
