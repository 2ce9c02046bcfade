#include "eval/evaluate.hpp"

#include <tbb/enumerable_thread_specific.h>

#include "base/in_order.hpp"
#include "base/verify.hpp"
#include "case/horizons.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/run_work.hpp"
#include "method/ask.hpp"
#include "method/by_spec.hpp"

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

/// What one thread keeps: its methods, and the case that it checked last.
struct Asker {
  MethodSet methods;
  std::optional<std::uint64_t> index;
  CheckedCase known;
  SearchOptions search;

  /// Errors: the case is refuted.
  Result<void> take(const NamedCase& named, std::uint64_t at, const EvaluateOptions& options) {
    if (index == at) return {};
    search = options.search_for ? options.search_for(named.value) : options.search;
    return check_case(named).map([&](CheckedCase checked) {
      known = std::move(checked);
      index = at;
    });
  }
};

AnswerRecord answer_item(const std::string& id, const CheckedCase& known, const Item& item,
                         const std::string& spec, Method& method, const SearchOptions& search) {
  const std::optional<CheckedCase> moved =
      item.factor ? at_horizon(known, *item.factor) : std::nullopt;
  const CheckedCase& asked = moved ? *moved : known;
  const Origin& origin = asked.value().origin;
  const Judged judged = ask(method, asked, search);
  const Answer& answer = judged.answer;
  AnswerRecord record;
  record.index = item.index;
  record.id = id;
  record.contact = origin.contact.empty() ? "-" : origin.contact;
  record.kind = origin.kind;
  record.collides = asked.collides();
  record.factor = item.factor;
  record.method = spec;
  record.t_max = asked.query().t_max;
  record.verdict = answer.verdict;
  if (answer.has_toi()) record.toi = answer.toi;
  record.outcome = judged.outcome;
  record.pops = answer.pops;
  record.bytes = answer.bytes;
  record.seconds = answer.seconds;
  return record;
}

}  // namespace

Result<bool> evaluate(const std::vector<NamedCase>& cases, const EvaluateOptions& options,
                      const std::function<void(const AnswerRecord&, double share)>& on_answer,
                      const std::atomic<bool>* stop) {
  const std::vector<Item> items = items_of(cases, options);
  const std::uint64_t methods_each = options.methods.size();
  const std::uint64_t total = items.size() * methods_each;
  CCDFUZZ_VERIFY(options.skip <= total);
  std::uint64_t done = options.skip;
  tbb::enumerable_thread_specific<Asker> askers;
  Result<void> checked;
  std::atomic<bool> ended = false;
  struct Row {
    Result<AnswerRecord> record;
    std::uint64_t checking;
  };
  run_in_order<Row>(
      total - options.skip, options.threads,
      [&](size_t i) -> Row {
        const std::uint64_t index = options.skip + i;
        const Item& item = items[index / methods_each];
        const std::string& spec = options.methods[index % methods_each];
        Asker& asker = askers.local();
        const std::uint64_t before = work_done_here();
        const auto known = asker.take(cases[item.index], item.index, options);
        const std::uint64_t checking = work_done_here() - before;
        return {known.map([&] {
                  return answer_item(cases[item.index].id, asker.known, item, spec,
                                     asker.methods[spec], asker.search);
                }),
                checking};
      },
      [&](const Row& row) {
        const auto& [record, checking] = row;
        if (checked) {
          checked = record ? RunWork::add(cases[record->index], checking)
                           : Result<void>(tl::unexpected(record.error()));
        }
        if (checked) on_answer(*record, static_cast<double>(++done) / static_cast<double>(total));
        if (!checked || (stop && stop->load(std::memory_order_relaxed))) ended = true;
      },
      &ended);
  if (!checked) return tl::unexpected(checked.error());
  return done == total;
}

}  // namespace ccdfuzz
