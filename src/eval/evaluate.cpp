#include "eval/evaluate.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <tuple>

#include "eval/horizons.hpp"
#include "eval/in_order.hpp"
#include "eval/paper_rates.hpp"
#include "query/taxonomy.hpp"

namespace ccdfuzz {

namespace {

/// One query of the evaluation: a case, and how far past its contact to ask.
struct Item {
  const NamedCase* source;
  std::optional<double> factor;
};

std::vector<Item> items_of(const std::vector<NamedCase>& cases,
                           const std::vector<double>& factors) {
  std::vector<Item> items;
  for (const NamedCase& named : cases) {
    if (factors.empty() || !named.value.truth.witness) {
      items.push_back({&named, std::nullopt});
      continue;
    }
    for (const double factor : factors) {
      if (at_horizon(named.value, factor)) items.push_back({&named, factor});
    }
  }
  return items;
}

EvaluatedRow answer_item(const Item& item, const std::string& method, MethodSet& methods,
                         const SearchOptions& search) {
  const std::optional<Case> moved =
      item.factor ? at_horizon(item.source->value, *item.factor) : std::nullopt;
  const Case& asked = moved ? *moved : item.source->value;
  return {item.source, item.factor, method, asked.query.t_max, ask(methods[method], asked, search)};
}

std::string contact_of(const NamedCase& named) {
  const std::string& contact = named.value.origin.contact;
  return contact.empty() ? "-" : contact;
}

/// The paper's classes in its order, then the rest.
size_t rank_of(const std::string& contact) {
  const std::optional<ContactClass> known = contact_class_named(contact);
  return known ? static_cast<size_t>(*known) : kContactClasses.size();
}

size_t position(const std::vector<std::string>& methods, const std::string& method) {
  return static_cast<size_t>(std::ranges::find(methods, method) - methods.begin());
}

std::string factor_text(const std::optional<double>& factor) {
  if (!factor) return "as given";
  if (*factor == 1 + 0x1p-30) return "t*(1+2^-30)";
  return *factor == 1 ? "t*" : fmt::format("{} t*", *factor);
}

std::string rate_text(std::uint64_t count, std::uint64_t total) {
  if (total == 0) return "-";
  return fmt::format("{}/{} = {:.1f} %", count, total,
                     100.0 * static_cast<double>(count) / static_cast<double>(total));
}

}  // namespace

std::vector<EvaluatedGroup> evaluate(
    const std::vector<NamedCase>& cases, const EvaluateOptions& options,
    const std::function<void(const EvaluatedRow&, double share)>& on_row,
    const std::atomic<bool>* stop) {
  const std::vector<Item> items = items_of(cases, options.horizon_factors);
  const size_t total = items.size() * options.methods.size();

  using Key = std::tuple<size_t, std::string, std::optional<double>, size_t>;
  std::map<Key, EvaluatedGroup> groups;
  size_t done = 0;
  tbb::enumerable_thread_specific<MethodSet> methods;
  run_in_order<EvaluatedRow>(
      total, options.threads,
      [&](size_t index) {
        return answer_item(items[index / options.methods.size()],
                           options.methods[index % options.methods.size()], methods.local(),
                           options.search);
      },
      [&](const EvaluatedRow& row) {
        const std::string contact = contact_of(*row.source);
        EvaluatedGroup& group =
            groups[{rank_of(contact), contact, row.factor, position(options.methods, row.method)}];
        group.contact = contact;
        group.factor = row.factor;
        group.method = row.method;
        group.tally.add(row.judged.answer, row.judged.outcome, row.source->value.truth.collides);
        group.timings.add(row.judged.answer.seconds);
        on_row(row, static_cast<double>(++done) / static_cast<double>(total));
      },
      stop);

  std::vector<EvaluatedGroup> ordered;
  ordered.reserve(groups.size());
  for (auto& [key, group] : groups) ordered.push_back(std::move(group));
  return ordered;
}

Table performance_table(const std::vector<EvaluatedGroup>& groups) {
  const bool horizons = std::ranges::any_of(groups, [](const auto& g) { return bool(g.factor); });
  std::vector<Table::Column> columns = {{"class", Align::kLeft}};
  if (horizons) columns.push_back({"t_max", Align::kLeft});
  columns.push_back({"method", Align::kLeft});
  for (const char* title : {"n", "mean", "median", "p99", "FN missed", "FN late", "FP", "undecided",
                            "unknown", "error"}) {
    columns.push_back({title});
  }
  Table table(columns);
  const EvaluatedGroup* previous = nullptr;
  for (const EvaluatedGroup& group : groups) {
    if (previous && (previous->contact != group.contact || previous->factor != group.factor)) {
      table.start_group();
    }
    previous = &group;
    const Tally& tally = group.tally;
    const auto count = [&](Outcome outcome, std::uint64_t of) -> TableCell {
      const std::uint64_t n = tally.count(outcome);
      const bool bad = is_false_negative(outcome) || outcome == Outcome::kError;
      return {count_text(n, of), n == 0 ? Emphasis::kFaint
                                 : bad  ? Emphasis::kBad
                                        : Emphasis::kPlain};
    };
    std::vector<TableCell> cells = {{group.contact}};
    if (horizons) cells.push_back({factor_text(group.factor)});
    cells.insert(cells.end(), {{group.method},
                               {fmt::format("{}", tally.n)},
                               {duration_text(tally.mean_seconds())},
                               {duration_text(group.timings.median())},
                               {duration_text(group.timings.p99())},
                               count(Outcome::kMissed, tally.positives),
                               count(Outcome::kLate, tally.positives),
                               count(Outcome::kFalsePositive, tally.negatives),
                               count(Outcome::kUndecided, tally.n),
                               count(Outcome::kUnknown, tally.n),
                               count(Outcome::kError, tally.n)});
    table.add_row(std::move(cells));
  }
  return table;
}

Table paper_table(const std::vector<EvaluatedGroup>& groups) {
  Table table({{"class", Align::kLeft},
               {"method", Align::kLeft},
               {"FN missed"},
               {"paper's FN"},
               {"FP"},
               {"paper's FP"}});
  // With horizons, positive cases stand in the group at t* and negative ones in the group as given.
  std::vector<EvaluatedGroup> merged;
  for (const EvaluatedGroup& group : groups) {
    if (group.factor && *group.factor != 1) continue;
    const auto same = std::ranges::find_if(merged, [&](const EvaluatedGroup& m) {
      return m.contact == group.contact && m.method == group.method;
    });
    if (same == merged.end()) {
      merged.push_back(group);
    } else {
      same->tally.merge(group.tally);
    }
  }
  std::string previous;
  for (const EvaluatedGroup& group : merged) {
    if (group.contact != previous) table.start_group();
    previous = group.contact;
    const std::optional<PaperRates> paper = paper_rates(group.contact, group.method);
    const Tally& tally = group.tally;
    const auto paper_text = [&](PaperRate PaperRates::*which) -> TableCell {
      if (!paper) return {"-", Emphasis::kFaint};
      return {rate_text(((*paper).*which).count, ((*paper).*which).total)};
    };
    table.add_row({{group.contact},
                   {group.method},
                   {rate_text(tally.count(Outcome::kMissed), tally.positives)},
                   paper_text(&PaperRates::false_negatives),
                   {rate_text(tally.count(Outcome::kFalsePositive), tally.negatives)},
                   paper_text(&PaperRates::false_positives)});
  }
  return table;
}

}  // namespace ccdfuzz
