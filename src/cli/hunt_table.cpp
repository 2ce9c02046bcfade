#include "cli/hunt_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ccdfuzz {

Table hunt_table(const std::vector<HuntCell>& cells) {
  const bool refusals =
      std::ranges::any_of(cells, [](const HuntCell& cell) { return cell.tally.not_asked() > 0; });
  std::vector<Table::Column> columns = {{"class", Align::kLeft}, {"method", Align::kLeft}};
  for (const char* title : {"n", "mean", "FN missed", "FN late", "FP", "undecided", "error"}) {
    columns.push_back({title});
  }
  if (refusals) columns.push_back({"not asked"});
  for (const char* title : {"mutants", "lost"}) columns.push_back({title});
  Table table(columns);
  const HuntCell* previous = nullptr;
  for (const HuntCell& cell : cells) {
    if (previous && previous->contact != cell.contact) table.start_group();
    previous = &cell;
    const Tally& tally = cell.tally;
    const auto count = [&](Outcome outcome, std::uint64_t of) -> TableCell {
      const bool bad = is_false_negative(outcome) || outcome == Outcome::kError;
      const std::uint64_t n = tally.count(outcome);
      return {count_text(n, of), n == 0 ? Emphasis::kFaint
                                 : bad  ? Emphasis::kBad
                                        : Emphasis::kPlain};
    };
    std::vector<TableCell> row = {
        {std::string(name_of(cell.contact))},
        {cell.method},
        {fmt::format("{}", tally.n)},
        {tally.n == 0 ? "-" : duration_text(cell.cpu_seconds / static_cast<double>(tally.n))},
        count(Outcome::kMissed, tally.positives),
        count(Outcome::kLate, tally.positives),
        count(Outcome::kFalsePositive, tally.negatives),
        count(Outcome::kUndecided, tally.n),
        count(Outcome::kError, tally.n)};
    if (refusals) row.push_back({fmt::format("{}", tally.not_asked())});
    row.insert(row.end(), {{fmt::format("{}", cell.bred.mutants)},
                           {count_text(cell.bred.lost, cell.bred.mutants),
                            cell.bred.lost == 0 ? Emphasis::kFaint : Emphasis::kBad}});
    table.add_row(std::move(row));
  }
  return table;
}

}  // namespace ccdfuzz
