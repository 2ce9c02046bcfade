#include "properties/linear_queries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/double_parts.hpp"
#include "case/case_json.hpp"
#include "certify/linear/first_contact.hpp"
#include "certify/oracle/oracle.hpp"
#include "method/method.hpp"
#include "properties/draw_grazing.hpp"
#include "properties/draw_linear.hpp"

namespace ccdfuzz {

Check linear_decision_is_proven(const Query& query) {
  try {
    const Decision decision = decide(query);
    if (decision.truth.collides) return Check::holds();
    return Check::fails("undecided\n" + to_json({query, decision.truth, {}, {}}));
  } catch (const InternalError& error) {
    return Check::fails(fmt::format("{}\n{}", error.what(), to_json({query, {}, {}, {}})));
  }
}

Check no_false_negative_on_linear(const std::string& method, const Query& query,
                                  const SearchOptions& options) {
  auto contact = linear::first_contact(query);
  if (!contact) return Check::discarded("there is no contact");
  const auto solver = make_method(method);
  CCDFUZZ_VERIFY(solver);
  const Answer answer = (*solver)->answer(query, options);
  if (answer.verdict == Verdict::kUndecided) return Check::holds();
  std::string wrong;
  if (answer.verdict == Verdict::kMiss) {
    wrong = "misses a contact";
  } else {
    const Rational toi = exact(answer.toi.value());
    if (contact->time.sign_of(linear::Polynomial({-toi.get_num(), toi.get_den()})) < 0) {
      wrong = fmt::format("is late, with toi {}", to_hex(*answer.toi));
    }
  }
  if (wrong.empty()) return Check::holds();
  return Check::fails(fmt::format("{} {} at precision {}, contact in [{}, {}]\n{}", method, wrong,
                                  options.precision, to_text(contact->time.lo()),
                                  to_text(contact->time.hi()), to_json({query, {}, {}, {}})));
}

int most_places(const Query& query) {
  int most = 0;
  const DoubleParts step = parts_of(query.t_max);
  for (int k = 0; k < 3; ++k) {
    int least = std::numeric_limits<int>::max(), top = std::numeric_limits<int>::min();
    const auto note = [&](double x, int exponent, int above) {
      if (x == 0) return;
      least = std::min(least, parts_of(x).exponent + exponent);
      top = std::max(top, parts_of(x).top() + above);
    };
    for (const MovingPatch<double>& patch : query.patches) {
      for (const Vec3<double>& p : patch.positions) note(p[k], 0, 0);
      for (const Vec3<double>& v : patch.velocities) note(v[k], step.exponent, step.top());
    }
    if (least <= top) most = std::max(most, top - least);
  }
  return most;
}

Check linear_answer_is_exact(const Query& query, const SearchOptions& options) {
  const auto contact = linear::first_contact(query);
  const Answer answer = (*make_method("tdibm-c"))->answer(query, options);
  std::string wrong;
  if (answer.verdict != (contact ? Verdict::kHit : Verdict::kMiss)) {
    wrong = contact ? "misses a contact" : "finds a contact where there is none";
  } else if (contact) {
    // Enclosures of times are halved until they are narrower than a thousandth of the precision.
    const Rational toi = exact(*answer.toi), step = exact(query.t_max);
    const Rational allowed = exact(options.precision) * step;
    auto time = contact->time;
    while (time.hi() - time.lo() > allowed / 1024) time.refine();
    if (toi > time.hi()) wrong = "is late";
    if (time.lo() - toi > allowed) wrong = "is early";
  }
  if (wrong.empty()) return Check::holds();
  return Check::fails(fmt::format("tdibm-c {}, with toi {} at precision {}\n{}", wrong,
                                  answer.toi ? to_hex(*answer.toi) : "-", options.precision,
                                  to_json({query, {}, {}, {}})));
}

namespace {

/// A degenerate query, made different by as little as 2^-60 of its size, or with a coordinate of
/// another scale than the others.
Result<Query> draw_nearly_degenerate(ChoiceSource& choices) {
  Result<Query> drawn = draw_linear(choices);
  if (!drawn) return drawn;
  double size = 0;
  for (const MovingPatch<double>& patch : drawn->patches) {
    for (const Vec3<double>& p : patch.positions) size = std::max(size, p.cwiseAbs().maxCoeff());
  }
  const auto k = static_cast<int>(choices.choose(2));
  if (choices.coin()) {
    MovingPatch<double>& patch = drawn->patches[choices.choose(1)];
    const int exponent = -static_cast<int>(choices.integer(1, 60));
    const double gap = (choices.coin() ? -size : size) * std::ldexp(1, exponent);
    const bool one_corner = choices.coin();
    for (Vec3<double>& p : patch.positions) {
      p[k] += gap;
      if (one_corner) break;
    }
  }
  if (choices.coin()) {
    const int exponent = static_cast<int>(choices.integer(-60, 60));
    for (MovingPatch<double>& patch : drawn->patches) {
      for (Points<double>* points : {&patch.positions, &patch.velocities}) {
        for (Vec3<double>& p : *points) p[k] = std::ldexp(p[k], exponent);
      }
    }
  }
  return drawn;
}

Check check_linear_exact(ChoiceSource& choices) {
  const Result<Query> drawn =
      choices.choose(2) == 2 ? draw_grazing(choices) : draw_nearly_degenerate(choices);
  if (!drawn) return Check::discarded(drawn.error().message());
  if (most_places(*drawn) > 254) return Check::discarded("numbers of too many binary places");
  const SearchOptions options{.precision = choices.pick(std::array{1e-4, 1e-1, 1e-12})};
  return linear_answer_is_exact(*drawn, options);
}

Check check_linear_decision(ChoiceSource& choices) {
  const Result<Query> drawn = draw_linear(choices);
  return drawn ? linear_decision_is_proven(*drawn) : Check::discarded(drawn.error().message());
}

Check check_linear_answer(const std::string& method, ChoiceSource& choices,
                          const SearchOptions& options) {
  const Result<Query> drawn = draw_linear(choices);
  return drawn ? no_false_negative_on_linear(method, *drawn, options)
               : Check::discarded(drawn.error().message());
}

}  // namespace

std::vector<Property> linear_properties() {
  constexpr auto kHolds = Expectation::kHolds;
  constexpr const char* kClaim =
      "No contact of a degenerate linear query is missed, and none reported late";
  return {
      {"linear.decision_is_proven",
       "Degenerate linear queries are decided, and the independent checker accepts the decision",
       "src/certify/checker/check_linear.hpp", kHolds, check_linear_decision},
      {"tdibm-rational.no_false_negative_linear", kClaim, "exact arithmetic", kHolds,
       [](ChoiceSource& c) {
         constexpr SearchOptions kCoarse = {0x1p-6, 300, SearchOptions().max_bytes};
         return check_linear_answer("tdibm-rational", c, kCoarse);
       }},
      {"tdibm-c.no_false_negative_linear", kClaim, "src/ccd/certified/DERIVATION.md", kHolds,
       [](ChoiceSource& c) {
         constexpr SearchOptions kFine = {1e-4, 2000, SearchOptions().max_bytes};
         return check_linear_answer("tdibm-c", c, kFine);
       }},
      {"tdibm-c.linear_decided_exactly",
       "Degenerate linear queries, near ones and ones that graze are decided exactly, at a time "
       "within the precision",
       "src/ccd/certified/DERIVATION.md", kHolds, check_linear_exact},
  };
}

}  // namespace ccdfuzz
