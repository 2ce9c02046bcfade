#include "method/ask.hpp"

#include <exception>

#include "certify/checker/check_case.hpp"

namespace ccdfuzz {

namespace {

Judged failed(const std::exception& error, std::string name) {
  Answer answer;
  answer.note = error.what();
  return {std::move(answer), Outcome::kError, std::move(name)};
}

}  // namespace

Judged ask(Method& method, const CheckedCase& known, const SearchOptions& options) {
  Answered answer;
  try {
    answer = method.answer(known.query(), options);
  } catch (const MethodFault& fault) {
    return failed(fault, fault.name());
  } catch (const std::exception& error) {
    return failed(error, "exception");
  }
  // What throws here is no fault of the method.
  const Outcome outcome = judge(known, answer);
  // A wrong answer to the query itself weighs more.
  const bool wrong = is_false_negative(outcome) || outcome == Outcome::kFalsePositive;
  if (answer.broken_claim && !wrong) {
    return failed(*answer.broken_claim, answer.broken_claim->name());
  }
  const double late_by = outcome == Outcome::kLate ? delay_of(known, answer) : 0;
  return {std::move(answer), outcome, outcome == Outcome::kError ? "nonsense" : "", late_by};
}

Judged ask(Method& method, const Case& known, const SearchOptions& options) {
  return ask(method, checked_or_unknown(known), options);
}

}  // namespace ccdfuzz
