#include "eval/evaluate.hpp"

#include <tbb/enumerable_thread_specific.h>

#include "base/fields.hpp"
#include "case/horizons.hpp"
#include "certify/checker/check_case.hpp"
#include "eval/stream_cases.hpp"
#include "method/ask.hpp"
#include "method/by_spec.hpp"

namespace ccdfuzz {

namespace {

/// A case of the share, with the line of its answers if an earlier run gave them.
struct ToEvaluate {
  NamedCase of;
  std::uint64_t index = 0;
  std::optional<std::string> line;

  const NamedCase& named() const { return of; }
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
  given.pops = answer.pops;
  given.bytes = answer.bytes;
  given.seconds = answer.seconds;
  return given;
}

EvaluatedCase without_answers(const NamedCase& named, std::uint64_t index) {
  const Origin& origin = named.value.origin;
  return {index, named.id, origin.contact.empty() ? "-" : origin.contact, origin.kind, {}, {}};
}

Result<EvaluatedCase> ask_all(const ToEvaluate& item, const EvaluateOptions& options,
                              MethodSet& methods) {
  const Result<CheckedCase> known = check_case(item.of);
  if (!known) return tl::unexpected(known.error());
  const SearchOptions search =
      options.search_for ? options.search_for(item.of.value) : options.search;
  EvaluatedCase evaluated = without_answers(item.of, item.index);
  evaluated.collides = known->collides();
  const auto ask_up_to = [&](const CheckedCase& asked, std::optional<double> factor) {
    for (const std::string& spec : options.methods) {
      evaluated.answers.push_back(answer_of(asked, factor, spec, methods[spec], search));
    }
  };
  if (options.horizon_factors.empty() || !item.of.value.truth.witness) {
    ask_up_to(*known, std::nullopt);
    return evaluated;
  }
  for (const double factor : options.horizon_factors) {
    if (const auto moved = at_horizon(*known, factor)) ask_up_to(*moved, factor);
  }
  return evaluated;
}

/// The answers that an earlier run gave.
Result<EvaluatedCase> read_answers(const ToEvaluate& item) {
  const std::string where = "the earlier answers to " + item.of.id;
  Result<EvaluatedCase> read = from_json<EvaluatedCase>(*item.line, where);
  if (read && read->index != item.index) {
    return input_error(where,
                       fmt::format("are to case {} of the run, not {}", read->index, item.index));
  }
  return read;
}

}  // namespace

Result<void> evaluate(const std::vector<std::string>& files, const EvaluateOptions& options,
                      const EarlierLines& earlier, const OnEvaluated& on_case,
                      const std::function<bool()>& stop) {
  tbb::enumerable_thread_specific<MethodSet> methods;
  std::uint64_t next = 0;
  bool is_earlier = earlier != nullptr;
  Result<void> done;
  const Result<void> read = stream_cases<EvaluatedCase>(
      files, 1, options.threads,
      [&](NamedCase named) -> Result<std::shared_ptr<ToEvaluate>> {
        const std::uint64_t index = next++;
        if (index % options.shard.of != options.shard.index) return nullptr;
        auto item = std::make_shared<ToEvaluate>(ToEvaluate{std::move(named), index, {}});
        if (!is_earlier) return item;
        Result<std::optional<std::string>> line = earlier();
        if (!line) return tl::unexpected(line.error());
        item->line = *std::move(line);
        is_earlier = item->line.has_value();
        return item;
      },
      [&](const ToEvaluate& item, size_t) {
        return item.line ? read_answers(item) : ask_all(item, options, methods.local());
      },
      [&](const ToEvaluate& item, size_t, const EvaluatedCase& evaluated, double share) {
        if (done) done = on_case(item.of, evaluated, !item.line, share);
      },
      [&] { return !done || stop(); });
  return read ? done : read;
}

}  // namespace ccdfuzz
