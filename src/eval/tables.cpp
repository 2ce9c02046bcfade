#include "eval/tables.hpp"

#include <cmath>
#include <map>

#include "eval/paper_rates.hpp"
#include "files/query_csv.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace {

std::string horizon_text(const std::optional<double>& factor) {
  if (!factor) return "as given";
  if (*factor == 1 + 0x1p-30) return "t*(1+2^-30)";
  return *factor == 1 ? "t*" : fmt::format("{} t*", *factor);
}

std::string rate_text(const PaperRate& rate) {
  if (rate.total == 0) return "-";
  return fmt::format("{}/{} = {:.1f} %", rate.count, rate.total,
                     100.0 * static_cast<double>(rate.count) / static_cast<double>(rate.total));
}

using PaperText = std::string (*)(const PaperResult& paper);

Column<Row> paper_column(const char* title, PaperText text) {
  return {{title}, [text](const Row& row) {
            const auto paper = paper_result(row.key.contact, row.key.kind, row.key.method);
            return TableCell{paper ? text(*paper) : "-"};
          }};
}

/// At the contact itself, or as given: the rows of the kinds (kinds_of), as `shown` if it is not
/// empty.
std::vector<Row> at_contact(const Rows& rows, std::initializer_list<std::string_view> kinds,
                            std::string_view shown = "") {
  return rows.in_order([&](RowKey key) -> std::optional<RowKey> {
    if (key.factor && *key.factor != 1) return std::nullopt;
    key.factor.reset();
    key.kind = kinds_of(key.kind);
    if (std::ranges::find(kinds, key.kind) == kinds.end()) return std::nullopt;
    if (!shown.empty()) key.kind = shown;
    return key;
  });
}

std::vector<Column<Row>> key_columns(bool kinds, bool horizons) {
  std::vector<Column<Row>> columns = {
      text_column<Row>("class", [](const Row& row) { return row.key.contact; })};
  if (kinds) {
    columns.push_back(text_column<Row>("kinds", [](const Row& row) { return row.key.kind; }));
  }
  if (horizons) {
    columns.push_back(
        text_column<Row>("t_max", [](const Row& row) { return horizon_text(row.key.factor); }));
  }
  columns.push_back(text_column<Row>("method", [](const Row& row) { return row.key.method; }));
  return columns;
}

Table paper_table(std::vector<Row> rows) {
  std::erase_if(rows, [](const Row& row) { return row.tally.n == 0; });  // all refused
  std::vector<Column<Row>> columns = key_columns(true, false);
  columns.insert(
      columns.end(),
      {time_column<Row>("mean", &LogHistogram::mean),
       paper_column("paper's", [](const PaperResult& p) { return duration_text(p.seconds); }),
       {{"FN missed"},
        [](const Row& row) {
          const std::uint64_t missed = row.tally.count(Outcome::kMissed);
          return TableCell{rate_text({missed, row.tally.judged_positives}), missed > 0};
        }},
       paper_column("paper's FN",
                    [](const PaperResult& p) {
                      return p.false_negatives ? rate_text(*p.false_negatives) : "-";
                    }),
       {{"FP"},
        [](const Row& row) {
          const std::uint64_t wrong = row.tally.count(Outcome::kFalsePositive);
          return TableCell{rate_text({wrong, row.tally.judged_negatives})};
        }},
       paper_column("paper's FP",
                    [](const PaperResult& p) { return rate_text(p.false_positives); })});
  add_outcomes(columns, met_in(rows, {Outcome::kLate, Outcome::kUndecided, Outcome::kUnknown,
                                      Outcome::kError}));
  return table_of(rows, columns, &are_beside);
}

/// Below Tables 1, 2 and 4.
constexpr const char* kPaperNote =
    "The paper's are of quadratic triangles, as `ccdfuzz generate --paper` makes them\n";

/// Below Tables 1 and 2: of how many queries no rate says anything. The proven ones of a set can be
/// easier than the others.
std::string unproven_note(const Rows& rows) {
  std::map<std::string, std::uint64_t> unproven;  // by class, of the method that was asked most
  for (const Row& row : at_contact(rows, {kRegularKinds, kGrazingKinds}, "all")) {
    std::uint64_t& most = unproven[row.key.contact];
    most = std::max(most, row.tally.n - row.tally.positives - row.tally.negatives);
  }
  std::uint64_t count = 0;
  for (const auto& [contact, most] : unproven) count += most;
  if (count == 0) return kPaperNote;
  return kPaperNote +
         fmt::format(
             "No rate counts queries without a certificate: {}; `ccdfuzz prove` makes one\n",
             count);
}

/// "-" where no answer says it.
Column<Row> memory_column(const char* title, double (LogHistogram::*of)() const) {
  return {{title}, [of](const Row& row) {
            const LogHistogram& bytes = row.tally.bytes;
            return TableCell{bytes.largest() > 0 ? size_text((bytes.*of)()) : "-"};
          }};
}

/// Appends a column of how late the latest hits are, if any are late.
void add_late_column(std::vector<Column<Row>>& columns, const std::vector<Row>& rows) {
  const auto late_by = [](const Row& row) { return row.tally.late_by; };
  if (std::ranges::none_of(rows, [&](const Row& row) { return late_by(row) > 0; })) return;
  columns.push_back({{"late by ≤"}, [=](const Row& row) {
                       const bool is_known = 0 < late_by(row) && std::isfinite(late_by(row));
                       return TableCell{is_known ? fmt::format("{:.2g}", late_by(row)) : "-"};
                     }});
}

}  // namespace

Table methods_table(const std::vector<Row>& rows) {
  std::vector<Column<Row>> columns = {
      text_column<Row>("method", [](const Row& row) { return row.key.method; })};
  columns.front().most_width = 17;
  add_outcomes(columns,
               {Outcome::kMissed, Outcome::kLate, Outcome::kFalsePositive, Outcome::kUndecided});
  add_outcomes(columns, met_in(rows, {Outcome::kUnknown, Outcome::kError}));
  add_late_column(columns, rows);
  add_refused_column(columns, rows);
  columns.insert(columns.end(), {time_column<Row>("mean", &LogHistogram::mean),
                                 time_column<Row>("median", &LogHistogram::median),
                                 time_column<Row>("p99", &LogHistogram::p99),
                                 memory_column("memory", &LogHistogram::mean)});
  return table_of(rows, columns, &are_beside);
}

Table performance_table(const std::vector<Row>& rows) {
  const bool kinds = std::ranges::any_of(
      rows, [&](const Row& row) { return row.key.kind != rows.front().key.kind; });
  const bool horizons =
      std::ranges::any_of(rows, [](const Row& row) { return row.key.factor.has_value(); });
  std::vector<Column<Row>> columns = key_columns(kinds, horizons);
  columns.insert(columns.end(), {asked_column<Row>(), time_column<Row>("mean", &LogHistogram::mean),
                                 time_column<Row>("median", &LogHistogram::median),
                                 time_column<Row>("p99", &LogHistogram::p99),
                                 memory_column("memory", &LogHistogram::mean),
                                 memory_column("p99 mem", &LogHistogram::p99)});
  add_outcomes(columns, {Outcome::kMissed, Outcome::kLate, Outcome::kFalsePositive,
                         Outcome::kUndecided, Outcome::kUnknown, Outcome::kError});
  add_late_column(columns, rows);
  add_refused_column(columns, rows);
  return table_of(rows, columns, &are_beside);
}

Table paper_table_1(const Rows& rows) {
  const std::vector<Row> halves = by_kinds(rows);
  const auto has = [&](std::string_view kinds) {
    return std::ranges::any_of(halves, [&](const Row& row) { return row.key.kind == kinds; });
  };
  return paper_table(has(kRegularKinds) && has(kGrazingKinds)
                         ? at_contact(rows, {kRegularKinds, kGrazingKinds}, "all")
                         : std::vector<Row>());
}

Table paper_table_2(const Rows& rows) {
  std::vector<Row> halves = at_contact(rows, {kRegularKinds});
  std::ranges::copy(at_contact(rows, {kGrazingKinds}), std::back_inserter(halves));
  return paper_table(std::move(halves));
}

Table paper_table_3(const Rows& rows) {
  return paper_table(at_contact(rows, {kLinearKind}));
}

std::string answers_path(const std::string& folder) {
  return folder + "/answers.jsonl";
}

std::vector<NamedTable> evaluation_tables(const Rows& rows,
                                          const std::vector<GenerationCost>& costs) {
  std::vector<NamedTable> tables = {{"Performance", performance_table(by_kinds(rows))}};
  const auto add = [&](const char* title, Table table, const std::string& note = "") {
    if (table.row_count() > 0) tables.push_back({title, std::move(table), note});
  };
  add("Table 1, beside the paper's", paper_table_1(rows), unproven_note(rows));
  add("Table 2, beside the paper's", paper_table_2(rows), unproven_note(rows));
  add("Table 3, beside the paper's", paper_table_3(rows), kLinearNote);
  add("Table 4: making the cases, beside the paper's", generation_table(costs), kPaperNote);
  return tables;
}

Result<void> write_tables(const std::string& folder, const Rows& rows,
                          const std::vector<GenerationCost>& costs) {
  std::string markdown, lines;
  for (const auto& [title, table, note] : evaluation_tables(rows, costs)) {
    markdown +=
        fmt::format("{}## {}\n\n{}", markdown.empty() ? "" : "\n", title, table.to_markdown());
    if (!note.empty()) markdown += "\n" + note;
  }
  if (const std::string notes = column_notes(by_methods(rows)); !notes.empty()) {
    markdown += "\n" + notes;
  }
  for (const GenerationCost& cost : costs) lines += to_json(cost) + "\n";
  for (const Row& row : by_kinds(rows)) lines += to_json(row) + "\n";
  return write_file(folder + "/tables.md", markdown).and_then([&] {
    return write_file(folder + "/rows.jsonl", lines);
  });
}

}  // namespace ccdfuzz
