#include "eval/evaluate.hpp"

#include "eval/horizons.hpp"
#include "io/fields.hpp"
#include "method/ask.hpp"

namespace ccdfuzz {

namespace {

GivenAnswer answer_of(const CheckedCase& asked, std::optional<double> factor,
                      const std::string& spec, Method& method, const SearchOptions& search) {
  const Judged judged = ask(method, asked, search);
  const Answer& answer = judged.answer;
  GivenAnswer given;
  given.factor = factor;
  given.method = spec;
  given.t_max = asked.query().t_max;
  given.verdict = answer.verdict;
  if (answer.has_toi()) given.toi = answer.toi;
  given.outcome = judged.outcome;
  given.late_by = judged.late_by;
  given.cost = answer;
  return given;
}

EvaluatedCase ask_all(const CaseToEvaluate& item, const CheckedCase& known,
                      const EvaluateOptions& options, MethodSet& methods) {
  const SearchOptions search = options.search_for(item.value);
  const Origin& origin = item.value.origin;
  EvaluatedCase evaluated{
      item.index,  item.id,          origin.contact.empty() ? "-" : origin.contact,
      origin.kind, known.collides(), {}};
  const auto ask_up_to = [&](const CheckedCase& asked, std::optional<double> factor) {
    for (const std::string& spec : options.methods) {
      evaluated.answers.push_back(answer_of(asked, factor, spec, methods[spec], search));
    }
  };
  if (options.horizon_factors.empty() || !known.contact_by()) {
    ask_up_to(known, std::nullopt);
    return evaluated;
  }
  for (const double factor : options.horizon_factors) {
    const std::optional<double> t_max = horizon_of(known.value(), factor);
    if (t_max) ask_up_to(known.with_t_max(*t_max), factor);
  }
  return evaluated;
}

/// The answers that an earlier run gave.
Result<EvaluatedCase> read_answers(const CaseToEvaluate& item) {
  const auto& [where, json] = *item.line;
  Result<EvaluatedCase> read = from_json<EvaluatedCase>(json, where);
  if (read && (read->index != item.index || read->id != item.id)) {
    return input_error(where, "is of case {}, {}, not {}, {}", read->index, read->id, item.index,
                       item.id);
  }
  return read;
}

}  // namespace

Result<std::optional<CaseToEvaluate>> CasesToEvaluate::next() {
  CCDFUZZ_TRY(auto named, cases_.next());
  for (; named && index_ % shard_.of != shard_.index; ++index_) {
    CCDFUZZ_TRY(named, cases_.next());
  }
  if (!named) return std::nullopt;
  CaseToEvaluate item{*std::move(named), index_++, {}};
  if (earlier_ == nullptr) return item;
  CCDFUZZ_TRY(const auto line, earlier_->next());
  if (line) item.line = {earlier_->where(), std::string(*line)};
  return item;
}

Result<EvaluatedCase> evaluated(CaseToEvaluate& item, const EvaluateOptions& options,
                                MethodSet& methods) {
  return decided_and_checked(item).and_then([&](const CheckedCase& known) {
    return item.line ? read_answers(item) : ask_all(item, known, options, methods);
  });
}

}  // namespace ccdfuzz
