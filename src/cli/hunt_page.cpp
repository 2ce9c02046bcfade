#include "cli/hunt_page.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <map>

#include "cli/hunt_table.hpp"
#include "cli/output.hpp"
#include "cli/reproduction.hpp"
#include "finds/entries.hpp"

namespace ccdfuzz {

namespace {

ReportedCase reported_find(const std::string& path, const Case& value, bool is_new) {
  ReportedCase reported;
  reported.id = path;
  reported.value = value;
  for (const auto& [method, expected] : value.expect) {
    reported.answers.push_back({method, expected.outcome, std::nullopt});
  }
  reported.is_new = is_new;
  reported.reproduce = reproduction(path, value.expect);
  return reported;
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
  if (std::error_code error; !std::filesystem::is_directory(record.store, error)) {
    add_absent_finds(record, report);
    return report;
  }
  const Result<std::vector<std::string>> paths = list_entries(record.store);
  if (!paths) return tl::unexpected(paths.error());
  if (!paths->empty()) {
    const Result<std::vector<NamedCase>> entries = load_corpus(record.store);
    if (!entries) return tl::unexpected(entries.error());
    std::map<std::string, const Case*> known;
    for (const NamedCase& entry : *entries) known.emplace(entry.id, &entry.value);
    for (const std::string& path : record.finds) {
      const auto found = known.find(path);
      if (found == known.end()) continue;  // a later hunt has found a smaller one
      report.cases.push_back(reported_find(path, *found->second, true));
      known.erase(found);
    }
    for (const auto& [path, value] : known) {
      report.cases.push_back(reported_find(path, *value, false));
    }
  }
  keep_most_telling(report);
  return report;
}

}  // namespace ccdfuzz
