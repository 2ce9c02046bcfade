#include "cli/hunt_table.hpp"

#include <fmt/format.h>

#include "eval/row_columns.hpp"

namespace ccdfuzz {

Table hunt_table(const std::vector<HuntCell>& cells) {
  std::vector<Column<HuntCell>> columns = {
      text_column<HuntCell>("class", [](const HuntCell& cell) { return name_of(cell.contact); }),
      text_column<HuntCell>("method", [](const HuntCell& cell) { return cell.method; }),
      asked_column<HuntCell>(),
      measured_column<HuntCell>("mean",
                                [](const HuntCell& cell) {
                                  return duration_text(cell.cpu_seconds /
                                                       static_cast<double>(cell.tally.n));
                                }),
      outcome_column<HuntCell>("FN missed", Outcome::kMissed, &Tally::positives),
      outcome_column<HuntCell>("FN late", Outcome::kLate, &Tally::positives),
      outcome_column<HuntCell>("FP", Outcome::kFalsePositive, &Tally::negatives),
      outcome_column<HuntCell>("undecided", Outcome::kUndecided, &Tally::n),
      outcome_column<HuntCell>("error", Outcome::kError, &Tally::n)};
  add_refused_column(columns, cells);
  columns.push_back({"mutants", [](const HuntCell& cell) {
                       return TableCell{fmt::format("{}", cell.bred.mutants)};
                     }});
  columns.push_back({"lost", [](const HuntCell& cell) {
                       return count_cell(cell.bred.lost, cell.bred.mutants, true);
                     }});
  return table_of(cells, columns,
                  [](const HuntCell& a, const HuntCell& b) { return a.contact == b.contact; });
}

}  // namespace ccdfuzz
