#include "method/ask.hpp"

#include <fmt/format.h>

#include <exception>

#include "base/no_process.hpp"
#include "case/mesh.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/feature_depth.hpp"
#include "certify/oracle/oracle.hpp"
#include "files/check_file.hpp"

namespace ccdfuzz {

namespace {

Judged failed(const std::exception& error, std::string name) {
  Answer answer;
  answer.note = error.what();
  return {std::move(answer), Outcome::kError, std::move(name)};
}

}  // namespace

Outcome outcome_of(const CheckedCase& known, const Answered& answer, bool is_ordinary) {
  const Outcome outcome = judge(known, answer);
  const Query& query = known.query();
  const double tolerance = answer.terms.depth_tolerance;
  if (!is_false_negative(outcome) || !is_of_bodies(query)) return outcome;
  // A graze before a deep contact of a mesh is not ordinary, and hits of the deep one may be so
  // late. Nor is a touch at the start that has no depth.
  const bool starts_in_contact = *known.contact_by() == 0;
  const bool may_graze = is_ordinary && (has_mesh(query) || starts_in_contact);
  if (!(tolerance > 0) && !may_graze) return outcome;
  const Rational speed = greatest_speed(query);
  Rational most = exact(tolerance);
  if (may_graze) most += exact(answer.terms.time_tolerance) * speed;
  // Moved back by so much, they would not touch: no overlap is deeper than the way, but one at the
  // start. A hit after that is late by no more than the way.
  const bool is_late = outcome == Outcome::kLate;
  const Rational overlooked =
      is_late ? exact(*answer.toi) - *known.contact_by() : exact(query.t_max);
  if ((is_late || !starts_in_contact) && speed * overlooked <= most) return Outcome::kCorrect;
  const std::optional<double> depth =
      depth_of(known, {answer, outcome, "", 0, 0, answer.terms.in_plane});
  if (!depth) return Outcome::kUnknown;
  return *depth <= round_down(most) ? Outcome::kCorrect : outcome;
}

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
  if (is_of_bodies(query)) return depth_until(query, until, judged.in_plane);
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
  const Outcome outcome = outcome_of(known, answer, domain != nullptr && domain->ordinary);
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
  const bool in_plane = answer.terms.in_plane;
  const double in_depth = answer.terms.depth_tolerance, in_time = answer.terms.time_tolerance;
  const char* const error = outcome == Outcome::kError ? "nonsense" : "";
  return {std::move(answer), outcome, error, late_by, 0, in_plane, in_depth, in_time};
}

}  // namespace ccdfuzz
