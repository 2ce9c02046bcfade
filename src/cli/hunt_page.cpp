#include "cli/hunt_page.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <map>

#include "cli/common_options.hpp"
#include "cli/output.hpp"
#include "cli/reproduction.hpp"
#include "eval/row_columns.hpp"
#include "files/check_file.hpp"
#include "finds/entries.hpp"
#include "io/input_bytes.hpp"
#include "io/output_file.hpp"
#include "method/ask.hpp"

namespace ccdfuzz {

namespace {

namespace fs = std::filesystem;

/// A record has 200 samples and some thousand paths.
constexpr std::size_t kMostRecordBytes = 256 << 20;

/// The store and its finds as paths from here. They are as the command line gave them, unless the
/// record has been moved and the store with it.
void follow_store(const std::string& folder, HuntRecord& record) {
  std::error_code error;
  const fs::path beside = fs::canonical(fs::path(folder) / record.store_from, error);
  if (error || fs::equivalent(beside, record.store, error)) return;
  for (std::string& path : record.finds) {
    path = (beside / fs::path(path).lexically_relative(record.store)).string();
  }
  record.store = beside.string();
}

/// A page without its finds says where they were.
void add_absent_finds(const HuntRecord& record, ReportPage& report) {
  print_err(fmt::format("ccdfuzz: {}: the store of the hunt is not there; the page shows no find\n",
                        record.store));
  ReportTable table{
      "finds", "New counterexamples, not at hand: their store is not there", {"path"}, {}};
  for (const std::string& path : record.finds) table.rows.push_back({path});
  report.tables.push_back(std::move(table));
}

}  // namespace

Result<ReportedCase> reported_entry(NamedCase entry, MethodSet& methods) {
  const SearchOptions search = SearchFlags().options_for(entry.value);
  ReportedCase reported;
  for (const auto& [method, expected] : entry.value.expect) {
    const Outcome outcome = expected.outcome;
    const bool allowed = is_admitted(method);
    if (allowed && methods.find(method) == nullptr) {
      return input_error(entry.id + ": expect", make_method(method).error().what);
    }
    ReportedAnswer answer{method, outcome, std::nullopt};
    if (allowed && (outcome == Outcome::kLate || outcome == Outcome::kFalsePositive)) {
      const Result<CheckedCase> known = check_case(entry);
      if (!known) return tl::unexpected(known.error());
      const Judged judged = ask(methods[method], *known, search);
      if (judged.answer.verdict == Verdict::kHit) answer.toi = judged.answer.toi;
    }
    reported.answers.push_back(std::move(answer));
  }
  reported.id = entry.id;
  reported.precision = search.precision;
  reported.reproduce = reproduction(entry.id, entry.value.expect);
  reported.value = std::move(entry.value);
  return reported;
}

std::string hunt_record_path(const std::string& folder) {
  return folder + "/hunt.jsonl";
}

Result<void> write_hunt_record(const std::string& folder, HuntRecord record) {
  if (auto made = make_folder(folder); !made) return made;
  std::error_code error;
  record.store_from = fs::proximate(record.store, folder, error).string();
  return write_file(hunt_record_path(folder), to_json(record) + "\n");
}

Result<HuntRecord> read_hunt_record(const std::string& folder) {
  const std::string path = hunt_record_path(folder);
  return read_file(path, kMostRecordBytes)
      .and_then([&](const std::string& json) { return from_json<HuntRecord>(json, path); })
      .map([&](HuntRecord record) {
        if (!record.store_from.empty()) follow_store(folder, record);
        return record;
      });
}

Column<HuntCell> mean_column() {
  Column<HuntCell> column = measured_column<HuntCell>("mean", [](const HuntCell& cell) {
    return duration_text(cell.cpu_seconds / static_cast<double>(cell.tally.n));
  });
  column.least_width = 7;  // of any time
  return column;
}

bool any_is_traced(const std::vector<HuntCell>& cells) {
  return std::ranges::any_of(cells, [](const HuntCell& cell) {
    return !names_plugin(cell.method) && (cell.bred.lost > 0 || cell.bred.margin);
  });
}

void add_mutant_columns(std::vector<Column<HuntCell>>& columns,
                        const std::vector<HuntCell>& cells) {
  columns.push_back({"mutants", [](const HuntCell& cell) {
                       return TableCell{fmt::format("{}", cell.bred.mutants)};
                     }});
  if (!any_is_traced(cells)) return;
  columns.push_back({"lost", [](const HuntCell& cell) {
                       return names_plugin(cell.method)
                                  ? TableCell{"-", Emphasis::kFaint}
                                  : count_cell(cell.bred.lost, cell.bred.mutants, true);
                     }});
}

Table hunt_table(const std::vector<HuntCell>& cells) {
  std::vector<Column<HuntCell>> columns = {
      text_column<HuntCell>("class", [](const HuntCell& cell) { return name_of(cell.contact); }),
      text_column<HuntCell>("method", [](const HuntCell& cell) { return cell.method; }),
      asked_column<HuntCell>(),
      mean_column(),
      outcome_column<HuntCell>("missed", Outcome::kMissed, &Tally::positives),
      outcome_column<HuntCell>("late", Outcome::kLate, &Tally::positives),
      outcome_column<HuntCell>("FP", Outcome::kFalsePositive, &Tally::negatives),
      outcome_column<HuntCell>("undecided", Outcome::kUndecided, &Tally::n),
      outcome_column<HuntCell>("error", Outcome::kError, &Tally::n)};
  add_refused_column(columns, cells);
  add_mutant_columns(columns, cells);
  return table_of(cells, columns,
                  [](const HuntCell& a, const HuntCell& b) { return a.contact == b.contact; });
}

Result<ReportPage> hunt_page(const HuntRecord& record) {
  ReportPage report;
  report.title = fmt::format("Hunt of {:.0f} s", record.seconds);
  report.command = record.command;
  report.course = record.course;
  report.plugins = record.plugins;
  for (const HuntCell& cell : record.cells) {
    Row row{{std::string(name_of(cell.contact)), "", std::nullopt, cell.method}, cell.tally};
    row.tally.seconds = {};  // which the record of a hunt does not keep
    report.rows.push_back(std::move(row));
  }
  report.tables.push_back(
      report_table("hunt", "What the hunt asked, bred and lost", hunt_table(record.cells)));
  if (std::error_code error; !fs::is_directory(record.store, error)) {
    add_absent_finds(record, report);
    return report;
  }
  const Result<std::vector<std::string>> paths = list_entries(record.store);
  if (!paths) return tl::unexpected(paths.error());
  if (!paths->empty()) {
    const Result<std::vector<NamedCase>> entries = load_corpus(record.store);
    if (!entries) return tl::unexpected(entries.error());
    std::map<std::string, const NamedCase*> known;
    for (const NamedCase& entry : *entries) known.emplace(entry.id, &entry);
    std::vector<std::pair<const NamedCase*, bool>> shown;  // and whether it is new
    for (const std::string& path : record.finds) {
      const auto found = known.find(path);
      if (found == known.end()) continue;  // a later hunt has found a smaller one
      shown.emplace_back(found->second, true);
      known.erase(found);
    }
    for (const auto& [path, entry] : known) shown.emplace_back(entry, false);
    MethodSet methods;
    for (const auto& [entry, is_new] : shown) {
      Result<ReportedCase> reported = reported_entry(*entry, methods);
      if (!reported) return tl::unexpected(reported.error());
      reported->is_new = is_new;
      report.cases.push_back(std::move(*reported));
    }
  }
  keep_most_telling(report);
  return report;
}

}  // namespace ccdfuzz
