#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_text.hpp"
#include "eval/paper_tables.hpp"

namespace ccdfuzz {

namespace {

std::string horizon_text(const std::optional<double>& factor) {
  if (!factor) return "as given";
  if (*factor == 1 + 0x1p-30) return "t*(1+2^-30)";
  return *factor == 1 ? "t*" : fmt::format("{} t*", *factor);
}

}  // namespace

std::string to_json(const EvaluatedGroup& group) {
  const Tally& tally = group.tally;
  nlohmann::ordered_json row = {
      {"class", group.contact}, {"kinds", group.kinds}, {"t_max_factor", nullptr}};
  if (group.factor) row["t_max_factor"] = *group.factor;
  row.update({{"method", group.method},
              {"n", tally.n},
              {"positives", tally.positives},
              {"negatives", tally.negatives}});
  for (const Outcome outcome : kAllOutcomes) {
    row[std::string(name_of(outcome))] = tally.count(outcome);
  }
  row.update({{"mean_pops",
               tally.n == 0 ? 0 : static_cast<double>(tally.pops) / static_cast<double>(tally.n)},
              {"mean_bytes", group.bytes.mean()},
              {"median_bytes", group.bytes.median()},
              {"p99_bytes", group.bytes.p99()},
              {"max_bytes", group.bytes.largest()},
              {"mean_seconds", tally.mean_seconds()},
              {"median_seconds", group.seconds.median()},
              {"p99_seconds", group.seconds.p99()}});
  return json_text(row);
}

Table performance_table(const std::vector<EvaluatedGroup>& groups) {
  const bool horizons = std::ranges::any_of(groups, [](const auto& g) { return bool(g.factor); });
  const bool kinds = std::ranges::any_of(
      groups, [&](const EvaluatedGroup& g) { return g.kinds != groups.front().kinds; });
  std::vector<Table::Column> columns = {{"class", Align::kLeft}};
  if (kinds) columns.push_back({"kinds", Align::kLeft});
  if (horizons) columns.push_back({"t_max", Align::kLeft});
  const bool refusals =
      std::ranges::any_of(groups, [](const EvaluatedGroup& g) { return g.tally.not_asked() > 0; });
  columns.push_back({"method", Align::kLeft});
  for (const char* title : {"n", "mean", "median", "p99", "memory", "p99 mem", "FN missed",
                            "FN late", "FP", "undecided", "unknown", "error"}) {
    columns.push_back({title});
  }
  if (refusals) columns.push_back({"not asked"});
  Table table(columns);
  const EvaluatedGroup* previous = nullptr;
  for (const EvaluatedGroup& group : groups) {
    if (previous && (previous->contact != group.contact || previous->kinds != group.kinds ||
                     previous->factor != group.factor)) {
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
    const auto if_asked = [&](std::string text) -> TableCell {
      return tally.n > 0 ? TableCell{std::move(text)} : TableCell{"-", Emphasis::kFaint};
    };
    std::vector<TableCell> cells = {{group.contact}};
    if (kinds) cells.push_back({group.kinds});
    if (horizons) cells.push_back({horizon_text(group.factor)});
    cells.insert(cells.end(), {{group.method},
                               {fmt::format("{}", tally.n)},
                               if_asked(duration_text(tally.mean_seconds())),
                               if_asked(duration_text(group.seconds.median())),
                               if_asked(duration_text(group.seconds.p99())),
                               if_asked(size_text(group.bytes.mean())),
                               if_asked(size_text(group.bytes.p99())),
                               count(Outcome::kMissed, tally.positives),
                               count(Outcome::kLate, tally.positives),
                               count(Outcome::kFalsePositive, tally.negatives),
                               count(Outcome::kUndecided, tally.n),
                               count(Outcome::kUnknown, tally.n),
                               count(Outcome::kError, tally.n)});
    if (refusals) cells.push_back({fmt::format("{}", tally.not_asked())});
    table.add_row(std::move(cells));
  }
  return table;
}

}  // namespace ccdfuzz
