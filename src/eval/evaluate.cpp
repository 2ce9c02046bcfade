#include "eval/evaluate.hpp"

#include <tbb/enumerable_thread_specific.h>

#include "eval/horizons.hpp"
#include "eval/stream_cases.hpp"
#include "io/fields.hpp"
#include "method/ask.hpp"
#include "method/method_set.hpp"

namespace ccdfuzz {

namespace {

/// A case of the share, with its answers if an earlier run gave them.
struct ToEvaluate : NamedCase {
  struct Line {
    std::string where, json;
  };
  std::uint64_t index = 0;
  std::optional<Line> line;
};

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

EvaluatedCase ask_all(const ToEvaluate& item, const CheckedCase& known,
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
  if (options.horizon_factors.empty() || !item.value.truth.witness) {
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
Result<EvaluatedCase> read_answers(const ToEvaluate& item) {
  const auto& [where, json] = *item.line;
  Result<EvaluatedCase> read = from_json<EvaluatedCase>(json, where);
  if (read && (read->index != item.index || read->id != item.id)) {
    return input_error(where, fmt::format("is of case {}, {}, not {}, {}", read->index, read->id,
                                          item.index, item.id));
  }
  return read;
}

}  // namespace

Result<void> evaluate(const std::vector<std::string>& files, const EvaluateOptions& options,
                      RunLines* earlier, const OnEvaluated& on_case,
                      const std::function<bool()>& stop) {
  tbb::enumerable_thread_specific<MethodSet> methods;
  CaseStream cases(files);
  std::uint64_t index = 0;  // of the next case
  Result<void> done;
  const Result<void> read = stream_cases<EvaluatedCase>(
      options.threads,
      [&]() -> Result<std::optional<ToEvaluate>> {
        CCDFUZZ_TRY(auto named, cases.next());
        for (; named && index % options.shard.of != options.shard.index; ++index) {
          CCDFUZZ_TRY(named, cases.next());
        }
        if (!named) return std::nullopt;
        ToEvaluate item{*std::move(named), index++, {}};
        if (earlier == nullptr) return item;
        CCDFUZZ_TRY(const auto line, earlier->next());
        if (line) item.line = {earlier->where(), std::string(*line)};
        return item;
      },
      [&](ToEvaluate& item) {
        return decided_and_checked(item).and_then([&](const CheckedCase& known) {
          return item.line ? read_answers(item) : ask_all(item, known, options, methods.local());
        });
      },
      [&](const ToEvaluate& item, const EvaluatedCase& evaluated) {
        if (done) done = on_case(item, evaluated, !item.line);
      },
      [&] { return !done || stop(); });
  return read ? done : read;
}

}  // namespace ccdfuzz
