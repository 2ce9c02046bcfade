#include <fmt/format.h>

#include <cmath>

#include "case/case_json.hpp"
#include "case/judge.hpp"
#include "certify/checker/check_case.hpp"
#include "generators/draw_patch.hpp"
#include "method/method.hpp"
#include "properties/against_oracle.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

constexpr std::array kEveryMethod = {
    "trad",    "trad:aabb",       "tdibm",          "tdibm-h:1e-12", "tdibm-h:1e-12@absolute",
    "tdibm-e", "tdibm-e-literal", "tdibm-rational", "tdibm-c"};

/// Budgets that no drawn query makes long.
constexpr SearchOptions kShortSearch = {0x1p-4, 60, SearchOptions().max_bytes};

Answer answer_of(Method& method, const Query& query, const SearchOptions& options = kShortSearch) {
  Answer answer = method.answer(query, options);
  answer.seconds = 0;  // the one thing that may differ
  return answer;
}

bool same(const Answer& x, const Answer& y) {
  return x.verdict == y.verdict && x.toi == y.toi && x.uv == y.uv && x.pops == y.pops &&
         x.note == y.note;
}

/// A method answers as a fresh one does, whatever it was asked before.
Check check_no_state(Draw& choices) {
  const char* name = choices.pick(kEveryMethod);
  const Result<Case> first = draw_contact(choices, {}), second = draw_contact(choices, {});
  if (!first || !second) return Check::discarded("a number is not a double");
  const auto used = *make_method(name), fresh = *make_method(name);
  const Answer expected = answer_of(*fresh, first->query);
  answer_of(*used, second->query);
  if (same(answer_of(*used, first->query), expected) &&
      same(answer_of(*fresh, first->query), expected)) {
    return Check::holds();
  }
  return Check::fails(fmt::format("{} on\n{}\nafter\n{}", name, to_json(*first), to_json(*second)));
}

/// Any finite numbers in any two shapes: the answer is none that the judge calls an error, and
/// parameters of a hit lie in the patches' domains.
Check check_answers_make_sense(Draw& choices) {
  const char* name = choices.pick(kEveryMethod);
  Case drawn;
  drawn.query = draw_any_query(choices);
  const auto method = *make_method(name);
  const Answer answer = answer_of(*method, drawn.query);
  bool sensible = judge(checked_contact(drawn), answer) != Outcome::kError;
  if (answer.verdict == Verdict::kHit) {
    for (std::size_t s = 0; s < 2; ++s) {
      sensible = sensible && drawn.query.patches[s].shape.contains(answer.uv[s]);
    }
  }
  sensible = sensible && (answer.verdict != Verdict::kMiss || !answer.toi);
  return sensible ? Check::holds() : Check::fails(fmt::format("{} on\n{}", name, to_json(drawn)));
}

/// The optimised and the plain form of the paper's methods give the same answer, bit for bit.
Check check_optimised(Draw& choices) {
  constexpr std::array kPaper = {"tdibm", "tdibm-h:1e-12", "tdibm-h:1e-12@absolute", "tdibm-e",
                                 "tdibm-e-literal"};
  const std::string name = choices.pick(kPaper);
  const Result<Case> drawn = draw_contact(choices, {-1000, 900, 3});
  if (!drawn) return Check::discarded("a number is not a double");
  const auto fast = *make_method(name), plain = *make_method(name + std::string(kUnoptimised));
  if (same(answer_of(*fast, drawn->query), answer_of(*plain, drawn->query))) {
    return Check::holds();
  }
  return Check::fails(fmt::format("{} on\n{}", name, to_json(*drawn)));
}

/// A method that claims to miss nothing is never contradicted by what the oracle has proven of a
/// query with no known contact.
Check check_against_the_oracle(Draw& choices) {
  constexpr std::array kClaim = {"tdibm-c", "tdibm-rational"};
  const char* name = choices.pick(kClaim);
  Result<Case> drawn = draw_contact(choices, {-2, 2, 2});
  if (!drawn) return Check::discarded("a number is not a double");
  for (Vec3<double>& p : drawn->query.patches[1].positions) {
    p[2] += std::ldexp(static_cast<double>(choices.integer(-8, 8)), -6);
  }
  const Decided decided = decide_briefly(drawn->query);
  if (decided.check.status == Check::Status::kFails) return decided.check;
  if (decided.known.truth.collides != true) return Check::discarded("no contact is proven");
  return not_contradicted(name, **make_method(name), decided.known, kShortSearch);
}

constexpr std::array kWindowed = {"tdibm",   "tdibm-h:1e-12",   "tdibm-h:1e-12@absolute",
                                  "tdibm-e", "tdibm-e-literal", "tdibm-rational",
                                  "tdibm-c"};
constexpr SearchOptions kCoarseSearch = {0.5, 60, SearchOptions().max_bytes};

/// Asked up to t1 ≤ t2, a hit up to t1 and a miss up to t2 do not go together.
template <std::size_t N>
Check monotone_in_t_max(const std::array<const char*, N>& methods, const SearchOptions& options,
                        Draw& choices) {
  const char* name = choices.pick(methods);
  Result<Case> drawn = draw_contact(choices, {-2, 2, 2});
  if (!drawn) return Check::discarded("a number is not a double");
  for (Vec3<double>& p : drawn->query.patches[1].positions) {
    p[2] += std::ldexp(static_cast<double>(choices.integer(-8, 8)), -6);
  }
  Query shorter = drawn->query;
  shorter.t_max *= std::ldexp(static_cast<double>(choices.integer(0, 16)), -4);
  const auto method = *make_method(name);
  const Answer early = answer_of(*method, shorter, options);
  const Answer late = answer_of(*method, drawn->query, options);
  if (early.verdict != Verdict::kHit || late.verdict != Verdict::kMiss) return Check::holds();
  return Check::fails(fmt::format("{} hits up to {} but not after, on\n{}", name,
                                  to_hex(shorter.t_max), to_json(*drawn)));
}

/// Patches within 2^3 of their places, which are 2^7 apart along an axis, at speeds of less than 2:
/// a method says that they do not touch. One that always hits, or never decides, does not. Oriented
/// boxes have no axes where a surface is but a point, so most methods are asked about points.
Check check_far_apart(Draw& choices) {
  const char* name = choices.pick(kEveryMethod);
  const bool takes_anything =
      name == std::string_view("tdibm-c") || name == std::string_view("trad:aabb");
  Query query;
  query.t_max = 2;
  const auto along = static_cast<int>(choices.choose(2));
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    patch.shape = takes_anything ? draw_shape(choices, 2) : Shape::point();
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      Vec3<double> p, v;
      for (int k = 0; k < 3; ++k) p[k] = static_cast<double>(choices.integer(-8, 8));
      for (int k = 0; k < 3; ++k) v[k] = static_cast<double>(choices.integer(-15, 15)) / 8;
      if (s == 1) p[along] += 128;
      patch.positions.push_back(p);
      patch.velocities.push_back(v);
    }
  }
  const auto method = *make_method(name);
  const Answer answer = method->answer(query, kQuickSearch);
  if (answer.verdict == Verdict::kMiss) return Check::holds();
  return Check::fails(fmt::format("{} does not say so of\n{}", name, to_text(query)));
}

/// Two points meet: a method that claims to miss nothing says hit, and neither misses nor gives up.
Check check_meeting_points(Draw& choices) {
  constexpr std::array kSound = {"tdibm-e", "tdibm-rational", "tdibm-c"};
  const char* name = choices.pick(kSound);
  const double t = std::ldexp(static_cast<double>(choices.integer(0, 8)), -3);
  Vec3<double> meeting;
  for (int k = 0; k < 3; ++k) meeting[k] = static_cast<double>(choices.integer(-64, 64));
  Case asked;
  for (MovingPatch<double>& patch : asked.query.patches) {
    patch.shape = Shape::point();
    Vec3<double> v;
    for (int k = 0; k < 3; ++k) v[k] = static_cast<double>(choices.integer(-64, 64));
    patch.velocities = {v};
    patch.positions = {Vec3<double>(meeting - v * t)};
  }
  const auto method = *make_method(name);
  const Answer answer = method->answer(asked.query, kQuickSearch);
  if (answer.verdict == Verdict::kHit && *answer.toi <= t) return Check::holds();
  return Check::fails(fmt::format("{}, points that meet at {}\n{}", name, t, to_json(asked)));
}

}  // namespace

std::vector<Property> method_answers_claims() {
  constexpr auto kHolds = Expectation::kHolds, kFails = Expectation::kFails;
  return {
      {"methods.no_state", "A method answers as a fresh one does, whatever it was asked before",
       "src/method/method.hpp", kHolds, check_no_state},
      {"methods.sensible_answers",
       "On any finite numbers, toi is within [0, t_max] and parameters are in their domains",
       "src/case/judge.hpp", kHolds, check_answers_make_sense},
      {"methods.optimised", "The optimised form of a method of the paper answers as the plain one",
       "src/ccd/DERIVATION.md", kHolds, check_optimised},
      {"methods.not_contradicted", "No claim to miss nothing is contradicted by the oracle",
       "src/certify/oracle/oracle.hpp", kHolds, check_against_the_oracle},
      {"methods.not_contradicted_anywhere",
       "Nor on any finite numbers in any two shapes, and the checker accepts the oracle there",
       "src/certify/oracle/oracle.hpp", kHolds, check_claims_agree_anywhere},
      {"methods.monotone_in_t_max",
       "No method that narrows its windows hits up to a time and misses up to a later one; but two "
       "patches within the precision may be hit by other windows, and not by these",
       "Section 3", kFails, [](Draw& c) { return monotone_in_t_max(kWindowed, kCoarseSearch, c); }},
      {"trad.monotone_in_t_max",
       "The same where windows are halved: what is narrow depends on t_max", "Section 6 (1)",
       kFails, [](Draw& c) { return monotone_in_t_max(std::array{"trad"}, kCoarseSearch, c); }},
      {"methods.miss_what_is_far_apart", "Every method says of patches far apart that they miss",
       "Section 3", kHolds, check_far_apart},
      {"methods.hit_where_points_meet", "Methods that claim to miss nothing hit where points meet",
       "Section 3", kHolds, check_meeting_points},
  };
}

}  // namespace ccdfuzz
