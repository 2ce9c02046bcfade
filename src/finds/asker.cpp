#include "finds/asker.hpp"

#include <algorithm>

#include "ccd/witness_trace/loss_signature.hpp"
#include "certify/checker/check_case.hpp"

namespace ccdfuzz {

Asked asked_with(const SearchOptions& search) {
  return {search.precision, std::max(search.max_pops, Asked().max_pops)};
}

std::string cause_of_loss(const std::string& method, const Case& value, TracerSet& tracers) {
  const std::optional<Witness>& witness = value.truth.witness;
  if (!witness || witness->t > exact(value.query.t_max) || is_of_bodies(value.query)) return "";
  Tracer* const tracer = tracers.find(method);
  return tracer == nullptr ? "" : loss_cause(tracer->trace(value.query, *witness, {}));
}

std::string kind_of_bodies(const Query& query) {
  for (const MovingPatch<double>& body : query.patches) {
    if (!body.faces.empty()) return body.one_sided ? "one-sided mesh" : "mesh";
  }
  return has_spins(query) ? "spin" : has_turns(query) ? "turn" : "";
}

Expected Asker::expected(const std::string& method, const Case& value, const Judged& judged) {
  if (judged.outcome == Outcome::kError) return {judged.outcome, judged.error};
  if (!is_failure(judged.outcome)) return judged.outcome;
  if (is_of_bodies(value.query)) return {judged.outcome, kind_of_bodies(value.query)};
  if (!is_false_negative(judged.outcome)) return judged.outcome;
  return {judged.outcome, cause_ ? cause_(method, value) : cause_of_loss(method, value, tracers_)};
}

std::optional<Failure> Asker::failure(const std::string& method, const CheckedCase& known,
                                      const SearchOptions& search) {
  const Judged judged = ask(method, known, search);
  if (!is_failure(judged.outcome)) return std::nullopt;
  return failure_of(known.value(), method, expected(method, known.value(), judged));
}

std::optional<Failure> Asker::failure(const std::string& method, const CheckedCase& known) {
  return failure(method, known, search_);
}

std::optional<Failure> Asker::failure(const std::string& method, const Case& value) {
  return failure(method, checked_or_unknown(value));
}

SearchOptions Asker::search_as_asked(const CheckedCase& known) const {
  SearchOptions own = search_;
  own.precision = known.value().asked.precision;
  own.max_pops = std::min(own.max_pops, known.value().asked.max_pops);
  return own;
}

std::optional<Failure> Asker::failure_as_asked(const std::string& method,
                                               const CheckedCase& known) {
  return failure(method, known, search_as_asked(known));
}

Expected Asker::shown_as_asked(const std::string& method, const CheckedCase& known) {
  return expected(method, known.value(), ask(method, known, search_as_asked(known)));
}

double Asker::depth(const std::string& method, const CheckedCase& known) {
  const Judged judged = ask(method, known);
  return depth_of(known, judged).value_or(0);
}

void Asker::ask_others(Case& find, const std::vector<std::string>& methods) {
  SearchOptions few = search_;
  few.max_pops = std::min(few.max_pops, kEnoughPops);
  const CheckedCase known = checked_or_unknown(find);
  for (const std::string& method : methods) {
    if (find.expect.contains(method)) continue;
    const Judged judged = ask(method, known, few);
    if (judged.outcome == Outcome::kUndecided || judged.outcome == Outcome::kNotAsked) continue;
    find.expect[method] = expected(method, find, judged);
  }
}

}  // namespace ccdfuzz
