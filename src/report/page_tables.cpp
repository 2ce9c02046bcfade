#include "report/page_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "eval/table.hpp"
#include "numeric/verify.hpp"

namespace ccdfuzz {

namespace {

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

std::string course_csv(const HuntCourse& course) {
  std::string out = "seconds,queries,mutants,finds";
  for (const std::string& method : course.methods) out += "," + csv_field("margin_ulps " + method);
  out += "\n";
  for (const HuntSample& s : course.samples) {
    out += fmt::format("{},{},{},{}", s.seconds, s.queries, s.mutants, s.finds);
    for (const auto& margin : s.margins) out += margin ? fmt::format(",{}", *margin) : ",";
    out += "\n";
  }
  return out;
}

std::string drivers_csv(const Scoreboard& board) {
  std::string out =
      "driver,faults,killed,reached,triggered,clean_runs,false_alarms,median_seconds,"
      "median_executions,mean_seconds,censored\n";
  for (const ScoreboardDriver& d : board.drivers) {
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(d.driver), d.faults,
                       d.killed, d.reached, d.triggered, d.clean_runs, d.false_alarms, d.seconds,
                       d.executions, d.mean_seconds, d.censored ? 1 : 0);
  }
  return out;
}

std::string scoreboard_csv(const Scoreboard& board) {
  std::string out =
      "driver,fault,what,equivalent,runs,reached,triggered,detected,killed,seconds,executions,"
      "limit,found\n";
  for (const ScoreboardRow& r : board.rows) {
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(r.driver),
                       csv_field(r.fault), csv_field(r.what), r.equivalent ? 1 : 0, r.runs,
                       r.reached, r.triggered, r.detected, r.is_kill() ? 1 : 0, r.seconds,
                       r.executions, r.limit, csv_field(r.found));
  }
  return out;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> page_csvs(const ReportPage& report) {
  std::vector<std::pair<std::string, std::string>> files;
  if (!report.groups.empty()) files.emplace_back("groups.csv", groups_csv(report));
  if (!report.cases.empty()) files.emplace_back("counterexamples.csv", counterexamples_csv(report));
  if (!report.course.samples.empty()) files.emplace_back("course.csv", course_csv(report.course));
  if (!report.scoreboard.empty()) {
    files.emplace_back("scoreboard.csv", scoreboard_csv(report.scoreboard));
    files.emplace_back("scoreboard-drivers.csv", drivers_csv(report.scoreboard));
  }
  for (const ReportTable& table : report.tables) {
    CCDFUZZ_VERIFY(std::ranges::find(kReportTableIds, table.id) != kReportTableIds.end());
    files.emplace_back(table.id + ".csv", table_csv(table));
  }
  return files;
}

std::vector<std::string> all_page_csv_names() {
  std::vector<std::string> names = {"groups.csv", "counterexamples.csv", "course.csv",
                                    "scoreboard.csv", "scoreboard-drivers.csv"};
  for (const std::string_view id : kReportTableIds) names.push_back(std::string(id) + ".csv");
  return names;
}

}  // namespace ccdfuzz
