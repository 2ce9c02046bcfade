#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "eval/generation_cost.hpp"
#include "eval/rows.hpp"
#include "io/table.hpp"

namespace ccdfuzz {

/// A column of a table of rows.
template <class Row>
struct Column : Table::Column {
  std::function<TableCell(const Row&)> cell;
};

/// A table with a row for each of `rows`. A group ends where same_group(row, next) is false.
template <class Row, class SameGroup>
Table table_of(const std::vector<Row>& rows, const std::vector<Column<Row>>& columns,
               const SameGroup& same_group) {
  Table table({columns.begin(), columns.end()});
  for (size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && !same_group(rows[i - 1], rows[i])) table.start_group();
    std::vector<TableCell> cells;
    for (const Column<Row>& column : columns) cells.push_back(column.cell(rows[i]));
    table.add_row(std::move(cells));
  }
  return table;
}

// Columns that several tables have. A row is any type with a `tally`.

/// A text to the left.
template <class Row, class Text>
Column<Row> text_column(const char* title, const Text& text) {
  return {{title, Align::kLeft},
          [text](const Row& row) { return TableCell{std::string(text(row))}; }};
}

/// What stands below paper_table_3.
inline constexpr const char* kLinearNote =
    "Rates are of contacts, or of absences; the paper's are of all its queries\n";

/// As wide as any time is, so that the layout of a table does not depend on times.
inline constexpr size_t kTimeWidth = 7;

/// A time of the answers: "-" where there was none. has_mark: "≥" where any of them is undecided.
template <class Row>
Column<Row> time_column(const char* title, double (LogHistogram::*of)() const,
                        bool has_mark = true) {
  return {{title, Align::kRight, kTimeWidth}, [of, has_mark](const Row& row) {
            const LogHistogram& seconds = row.tally.seconds;
            if (seconds.count() == 0) return TableCell{"-"};
            const bool is_bound = has_mark && row.tally.count(Outcome::kUndecided) > 0;
            const std::string text = duration_text((seconds.*of)());
            return TableCell{is_bound ? fmt::format("≥ {:>{}}", text, kTimeWidth) : text};
          }};
}

/// A count with its share of `of`.
inline TableCell count_cell(std::uint64_t count, std::uint64_t of, bool is_bad) {
  return {count_text(count, of), is_bad && count > 0};
}

/// Appends for each outcome how many answers had it, of those that its rate is of. "-" where there
/// are none. has_share: with its share of these.
template <class Row>
void add_outcomes(std::vector<Column<Row>>& columns, const std::vector<Outcome>& outcomes,
                  bool has_share = true) {
  for (const Outcome outcome : outcomes) {
    const bool is_bad = is_false_negative(outcome) || outcome == Outcome::kError;
    const std::string title(outcome == Outcome::kFalsePositive ? "FP" : name_of(outcome));
    columns.push_back({{title}, [=](const Row& row) -> TableCell {
                         const std::uint64_t of = row.tally.of_which(outcome);
                         if (of == 0) return {"-"};
                         TableCell cell = count_cell(row.tally.count(outcome), of, is_bad);
                         if (!has_share) cell.text = fmt::format("{}", row.tally.count(outcome));
                         return cell;
                       }});
  }
}

/// Those of the outcomes that any row has.
template <class Row>
std::vector<Outcome> met_in(const std::vector<Row>& rows, std::vector<Outcome> outcomes) {
  std::erase_if(outcomes, [&](Outcome outcome) {
    return std::ranges::all_of(rows, [&](const Row& row) { return row.tally.count(outcome) == 0; });
  });
  return outcomes;
}

template <class Row>
Column<Row> asked_column() {
  return {{"n"}, [](const Row& row) { return TableCell{fmt::format("{}", row.tally.n)}; }};
}

/// Below a table: what its columns of false positives, late hits and refused queries count, and
/// what times are bounds. Empty if there is nothing in them.
template <class Row>
std::string column_notes(const std::vector<Row>& rows) {
  const auto wrong = [](const Row& row) { return row.tally.count(Outcome::kFalsePositive) > 0; };
  const auto late = [](const Row& row) { return row.tally.late_by > 0; };
  const auto refused = [](const Row& row) { return row.tally.not_asked() > 0; };
  const auto undecided = [](const Row& row) { return row.tally.count(Outcome::kUndecided) > 0; };
  return std::string(std::ranges::any_of(rows, wrong)
                         ? "FP: false positives, hits although nothing touches\n"
                         : "") +
         (std::ranges::any_of(rows, late)
              ? "late by ≤: the greatest known delay of a hit, in the unit of t\n"
              : "") +
         (std::ranges::any_of(rows, refused)
              ? "not asked: queries that a method refused; `ccdfuzz query` says why\n"
              : "") +
         (std::ranges::any_of(rows, undecided)
              ? "Where queries ended undecided, times are at least those\n"
              : "");
}

/// Appends a column of what was refused, if anything was.
template <class Row>
void add_refused_column(std::vector<Column<Row>>& columns, const std::vector<Row>& rows) {
  if (std::ranges::all_of(rows, [](const Row& row) { return row.tally.not_asked() == 0; })) return;
  columns.push_back({{"not asked"}, [](const Row& row) {
                       return TableCell{fmt::format("{}", row.tally.not_asked())};
                     }});
}

/// Everything that is known of each row of by_kinds.
Table performance_table(const std::vector<Row>& rows);

/// The same of each row of by_methods, without n and p99 mem. Columns of unknown, error and not
/// asked are left out if no method has any.
Table methods_table(const std::vector<Row>& rows);

/// Mean times, false positives and false negatives (missed: the paper's only sort) beside the
/// paper's; then what no rate counts, and late hits. Positives asked beyond the contact do not
/// count. Table 1: regular and grazing cases
/// as one, where the answers are to both; empty otherwise. Table 2: regular, then grazing cases.
/// Table 3: linear queries.
Table paper_table_1(const Rows& rows);
Table paper_table_2(const Rows& rows);
Table paper_table_3(const Rows& rows);

// An evaluation leaves three files in its folder. answers.jsonl is its run file: what was asked,
// and a line for each case with all answers to it. rows.jsonl has what the cases cost to make, and
// a line for each row of the table of performance. tables.md has the tables as they are printed.
// answers.jsonl appears last: once it is there the others are, too.

std::string answers_path(const std::string& folder);

/// The tables as they are printed: performance, Tables 1 to 3 beside the paper's, Table 4; those of
/// which there is nothing to say are left out.
struct NamedTable {
  std::string title;
  Table table;
  std::string note = {};  ///< a line below it; empty if there is none
};
std::vector<NamedTable> evaluation_tables(const Rows& rows,
                                          const std::vector<GenerationCost>& costs);

/// Writes rows.jsonl and tables.md. Errors: what the system says, naming the path.
Result<void> write_tables(const std::string& folder, const Rows& rows,
                          const std::vector<GenerationCost>& costs);

}  // namespace ccdfuzz
