#include "report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "eval/table.hpp"
#include "query/output_file.hpp"

namespace ccdfuzz {

namespace {

/// Class, kind and how each method did: what cases of one sort have in common.
std::string sort_of(const ReportedCase& reported) {
  std::string key = reported.value.origin.contact + " " + reported.value.origin.kind;
  for (const ReportedAnswer& answer : reported.answers) {
    key += fmt::format(" {}={}", answer.method, name_of(answer.outcome));
  }
  return key;
}

std::string optional_text(const std::optional<double>& x) {
  return x ? fmt::format("{}", *x) : "";
}

std::string groups_csv(const ReportPage& report) {
  std::string out = "class,kind,t_max_factor,method,n,positives,negatives";
  for (const Outcome outcome : kAllOutcomes) out += fmt::format(",{}", name_of(outcome));
  out += ",mean_seconds,median_seconds,p99_seconds\n";
  for (const ReportGroup& group : report.groups) {
    const Tally& tally = group.tally;
    out += fmt::format("{},{},{},{},{},{},{}", csv_field(group.contact), csv_field(group.kind),
                       optional_text(group.factor), csv_field(group.method), tally.n,
                       tally.positives, tally.negatives);
    for (const Outcome outcome : kAllOutcomes) out += fmt::format(",{}", tally.count(outcome));
    const bool timed = !group.timings.all().empty();
    out += timed ? fmt::format(",{},{},{}\n", tally.mean_seconds(), group.timings.median(),
                               group.timings.p99())
                 : ",,,\n";
  }
  return out;
}

std::string counterexamples_csv(const ReportPage& report) {
  std::string out = "case,class,kind,generator,method,outcome,toi\n";
  for (const ReportedCase& reported : report.cases) {
    const Origin& origin = reported.value.origin;
    for (const ReportedAnswer& answer : reported.answers) {
      out +=
          fmt::format("{},{},{},{},{},{},{}\n", csv_field(reported.id), csv_field(origin.contact),
                      csv_field(origin.kind), csv_field(origin.generator), csv_field(answer.method),
                      name_of(answer.outcome), optional_text(answer.toi));
    }
  }
  return out;
}

std::string table_csv(const ReportTable& table) {
  std::string out;
  const auto add = [&](const std::vector<std::string>& fields) {
    for (size_t i = 0; i < fields.size(); ++i) out += (i == 0 ? "" : ",") + csv_field(fields[i]);
    out += "\n";
  };
  add(table.columns);
  for (const std::vector<std::string>& row : table.rows) add(row);
  return out;
}

}  // namespace

ReportTable report_table(const std::string& id, const std::string& title, const Table& table) {
  return {id, title, table.titles(), table.texts()};
}

void keep_most_telling(ReportPage& report, std::size_t most) {
  if (report.cases.size() <= most) return;
  // Turn by turn: the n-th case of every sort before the (n+1)-th of any.
  std::map<std::string, std::size_t> seen;
  std::vector<std::pair<std::size_t, std::size_t>> order;  // turn, place
  for (std::size_t i = 0; i < report.cases.size(); ++i) {
    order.emplace_back(seen[sort_of(report.cases[i])]++, i);
  }
  std::ranges::sort(order);
  order.resize(most);
  std::ranges::sort(order, {}, &std::pair<std::size_t, std::size_t>::second);
  std::vector<ReportedCase> kept;
  kept.reserve(most);
  for (const auto& [turn, place] : order) kept.push_back(std::move(report.cases[place]));
  report.cases_left_out += report.cases.size() - most;
  report.cases = std::move(kept);
}

Result<void> write_report(const ReportPage& report, const std::string& folder, int threads) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return input_error(folder, "cannot make the folder: " + error.message());
  if (!report.groups.empty()) {
    if (auto done = write_file(folder + "/groups.csv", groups_csv(report)); !done) return done;
  }
  if (!report.cases.empty()) {
    const std::string csv = counterexamples_csv(report);
    if (auto done = write_file(folder + "/counterexamples.csv", csv); !done) return done;
  }
  for (const ReportTable& table : report.tables) {
    if (auto done = write_file(folder + "/" + table.id + ".csv", table_csv(table)); !done) {
      return done;
    }
  }
  return write_file(folder + "/index.html", report_page(report, threads));
}

}  // namespace ccdfuzz
