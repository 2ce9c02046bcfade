#include "eval/evaluate.hpp"

#include <tbb/enumerable_thread_specific.h>

#include "eval/ask.hpp"
#include "eval/by_spec.hpp"
#include "eval/horizons.hpp"
#include "eval/in_order.hpp"
#include "numeric/verify.hpp"

namespace ccdfuzz {

namespace {

/// One query of the evaluation: a case, and how far past its contact to ask.
struct Item {
  std::uint64_t index;
  std::optional<double> factor;
};

std::vector<Item> items_of(const std::vector<NamedCase>& cases, const EvaluateOptions& options) {
  std::vector<Item> items;
  for (std::uint64_t k = 0; k < options.shard.size(cases.size()); ++k) {
    const std::uint64_t index = options.shard.item(k);
    const Case& value = cases[index].value;
    if (options.horizon_factors.empty() || !value.truth.witness) {
      items.push_back({index, std::nullopt});
      continue;
    }
    for (const double factor : options.horizon_factors) {
      if (at_horizon(value, factor)) items.push_back({index, factor});
    }
  }
  return items;
}

AnswerRecord answer_item(const NamedCase& named, const Item& item, const std::string& spec,
                         Method& method, const SearchOptions& search) {
  const std::optional<Case> moved =
      item.factor ? at_horizon(named.value, *item.factor) : std::nullopt;
  const Case& asked = moved ? *moved : named.value;
  const Judged judged = ask(method, asked, search);
  const Answer& answer = judged.answer;
  AnswerRecord record;
  record.index = item.index;
  record.id = named.id;
  record.contact = asked.origin.contact.empty() ? "-" : asked.origin.contact;
  record.kind = asked.origin.kind;
  record.collides = asked.truth.collides;
  record.factor = item.factor;
  record.method = spec;
  record.t_max = asked.query.t_max;
  record.verdict = answer.verdict;
  if (answer.verdict != Verdict::kMiss) record.toi = answer.toi;
  record.outcome = judged.outcome;
  record.pops = answer.pops;
  record.bytes = answer.bytes;
  record.seconds = answer.seconds;
  return record;
}

}  // namespace

bool evaluate(const std::vector<NamedCase>& cases, const EvaluateOptions& options,
              const std::function<void(const AnswerRecord&, double share)>& on_answer,
              const std::atomic<bool>* stop) {
  const std::vector<Item> items = items_of(cases, options);
  const std::uint64_t methods_each = options.methods.size();
  const std::uint64_t total = items.size() * methods_each;
  CCDFUZZ_VERIFY(options.skip <= total);
  std::uint64_t done = options.skip;
  tbb::enumerable_thread_specific<MethodSet> methods;
  run_in_order<AnswerRecord>(
      total - options.skip, options.threads,
      [&](size_t i) {
        const std::uint64_t index = options.skip + i;
        const Item& item = items[index / methods_each];
        const std::string& spec = options.methods[index % methods_each];
        return answer_item(cases[item.index], item, spec, methods.local()[spec], options.search);
      },
      [&](const AnswerRecord& record) {
        on_answer(record, static_cast<double>(++done) / static_cast<double>(total));
      },
      stop);
  return done == total;
}

}  // namespace ccdfuzz
