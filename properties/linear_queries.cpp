#include "properties/linear_queries.hpp"

#include <fmt/format.h>

#include "certify/linear/first_contact.hpp"
#include "certify/oracle/oracle.hpp"
#include "method/method.hpp"
#include "properties/draw_linear.hpp"
#include "query/case_json.hpp"

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

namespace {

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
  };
}

}  // namespace ccdfuzz
