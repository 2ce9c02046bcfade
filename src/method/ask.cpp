#include "method/ask.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "base/no_process.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/feature_depth.hpp"
#include "certify/oracle/oracle.hpp"
#include "certify/oracle/outcome_of.hpp"
#include "files/check_file.hpp"

namespace ccdfuzz {

namespace {

Judged failed(const std::exception& error, std::string name) {
  Answer answer;
  answer.note = error.what();
  return {std::move(answer), Outcome::kError, std::move(name)};
}

}  // namespace

void decide_unknown(NamedCase& named) {
  const Query& query = named.value.query;
  if (is_decided_exactly(query) && named.value.truth == Truth()) {
    named.value.truth = decide(query).truth;
  }
}

Result<CheckedCase> decided_and_checked(NamedCase& named) {
  decide_unknown(named);
  return check_case(named);
}

std::optional<double> depth_of(const CheckedCase& known, const Judged& judged) {
  const Query& query = known.query();
  if (!is_false_negative(judged.outcome)) return std::nullopt;
  const double until = judged.outcome == Outcome::kLate ? *judged.answer.toi : query.t_max;
  if (is_of_bodies(query)) {
    const std::optional<double> depth = depth_until(query, until, judged.terms.in_plane);
    // That it is deeper than the tolerance is proven.
    return depth ? std::optional(std::max(*depth, judged.terms.depth_tolerance)) : depth;
  }
  const double depth = feature_depth(known.value(), until);
  return depth > 0 ? std::optional(depth) : std::nullopt;
}

Judged ask(Method& method, const CheckedCase& known, const SearchOptions& options) {
  const Domain* const domain = method.domain();
  if (std::string why = domain ? domain->broken_by(known.value()) : ""; !why.empty()) {
    return {no_answer(Verdict::kRefused, std::move(why)), Outcome::kNotAsked, ""};
  }
  Answered answer;
  try {
    answer = timed_answer(method, known.query(), options);
  } catch (const MethodFault& fault) {
    return failed(fault, fault.name());
  } catch (const NoProcess&) {
    throw;
  } catch (const std::exception& error) {
    return failed(error, "exception");
  }
  // By the terms of the answer (method.hpp). What throws here is no fault of the method.
  const Outcome outcome =
      outcome_of(known, answer, answer.terms, domain != nullptr && domain->ordinary);
  // A wrong answer to the query itself weighs more.
  const bool wrong = is_false_negative(outcome) || outcome == Outcome::kFalsePositive;
  if (answer.broken_claim && !wrong) {
    return failed(*answer.broken_claim, answer.broken_claim->name());
  }
  const bool is_late = outcome == Outcome::kLate;
  const double late_by = is_late ? delay_of(known, answer, answer.terms) : 0;
  if (is_false_negative(outcome)) {
    const Rational before = exact(is_late ? *answer.toi : known.query().t_max);
    if (const auto since = nearer_since(known, answer.terms, before)) {
      answer.note =
          fmt::format("the patches are nearer than the minimum separation {} from t = {:.10g}",
                      answer.terms.kept_separation, since->get_d());
    }
  }
  const bool is_far = outcome == Outcome::kFalsePositive && is_of_bodies(known.query());
  const double apart = is_far ? std::max(0.0, apart_at(known, *answer.toi)) : 0;
  const char* const error = outcome == Outcome::kError ? "nonsense" : "";
  return {answer, outcome, error, late_by, 0, answer.terms, apart};
}

}  // namespace ccdfuzz
