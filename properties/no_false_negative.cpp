#include "properties/no_false_negative.hpp"

#include <fmt/format.h>

#include "case/case_json.hpp"
#include "case/judge.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

Check no_false_negative(const std::string& method, const Case& value,
                        const SearchOptions& options) {
  if (!value.truth.witness || value.truth.collides != true) {
    return Check::discarded("no contact is proven");
  }
  const auto solver = make_method(method);
  CCDFUZZ_VERIFY(solver);
  const Answer answer = (*solver)->answer(value.query, options);
  const Outcome outcome = judge(checked_contact(value), answer);
  if (!is_false_negative(outcome) && outcome != Outcome::kError) return Check::holds();
  const std::string toi = answer.toi ? fmt::format(" at toi {}", to_hex(*answer.toi)) : "";
  return Check::fails(fmt::format("{} is {}{} at precision {}, contact at t = {}\n{}", method,
                                  name_of(outcome), toi, options.precision,
                                  to_text(value.truth.witness->t), to_json(value)));
}

Check check_no_false_negative(const std::string& method, const ContactRange& range, Draw& choices,
                              const SearchOptions& options) {
  const Result<Case> drawn = draw_contact(choices, range);
  if (!drawn) return Check::discarded(drawn.error().message());
  if (const auto checked = check_truth(*drawn); !checked) {
    return Check::fails("the drawn case is wrong: " + checked.error().message() + "\n" +
                        to_json(*drawn));
  }
  return no_false_negative(method, *drawn, options);
}

}  // namespace ccdfuzz
