#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/verify.hpp"
#include "case/taxonomy.hpp"
#include "eval/paper_rates.hpp"
#include "io/fields.hpp"
#include "io/in_order.hpp"
#include "method/method.hpp"
#include "report/case_details.hpp"
#include "report/pack.hpp"
#include "report/report.hpp"
#include "report/template.hpp"

namespace ccdfuzz {

namespace {

using Json = nlohmann::ordered_json;

/// Cases whose details are compressed together, and opened together by the page.
constexpr size_t kCasesPerChunk = 32;

/// A page of as many cases has room for the traces of the methods that did not fail on them.
constexpr size_t kFewCases = 200;

/// All methods of the report, as they first come.
std::vector<std::string> methods_of(const ReportPage& report) {
  std::vector<std::string> methods;
  const auto add = [&](const std::string& method) {
    if (std::ranges::find(methods, method) == methods.end()) methods.push_back(method);
  };
  for (const Row& row : report.rows) add(row.key.method);
  for (const ReportedCase& reported : report.cases) {
    for (const GivenAnswer& answer : reported.answers) add(answer.method);
  }
  return methods;
}

Json methods_json(const std::vector<std::string>& methods) {
  Json rows = Json::array();
  for (const std::string& method : methods) {
    Json row = {{"spec", method}};
    if (const Result<MethodInfo> info = method_info(method)) {
      row["description"] = info->description;
      row["claims"] = info->claims_no_false_negative;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// As rows.jsonl has it, and "times": [[bin of LogHistogram, count], …] of the seconds.
Json row_json(const Row& row) {
  Json json = Json::parse(to_json(row));
  if (row.tally.seconds.sum() > 0) json["times"] = row.tally.seconds.bins();
  return json;
}

/// The paper's Table 2 for the report's methods, on classes that hold no linear queries.
Json paper_json(const std::vector<Row>& own, const std::vector<std::string>& methods) {
  Json rows = Json::array();
  for (const ContactClass contact : kContactClasses) {
    const auto is_linear = [&](const Row& row) {
      return row.key.contact == name_of(contact) && row.key.kind == kLinearKind;
    };
    if (std::ranges::any_of(own, is_linear)) continue;
    for (const std::string& method : methods) {
      const auto paper = paper_result(name_of(contact), kRegularKinds, method);
      if (!paper || !paper->false_negatives) continue;
      const PaperRate &fn = *paper->false_negatives, &fp = paper->false_positives;
      rows.push_back({{"class", name_of(contact)},
                      {"method", method},
                      {"fn", {fn.count, fn.total}},
                      {"fp", {fp.count, fp.total}}});
    }
  }
  return rows;
}

/// {"methods", "samples": [[seconds, queries, mutants, finds, margins], …]}, or null.
Json course_json(const HuntCourse& course) {
  if (course.samples.empty()) return nullptr;
  Json samples = Json::array();
  for (const HuntSample& s : course.samples) {
    Json margins = Json::array();
    for (const auto& margin : s.margins) margins.push_back(margin ? Json(*margin) : Json());
    samples.push_back(Json::array({s.seconds, s.queries, s.mutants, s.finds, margins}));
  }
  return {{"methods", course.methods}, {"samples", samples}};
}

std::string script_element(const std::string& id, const char* type, const std::string& text) {
  return fmt::format("<script id=\"{}\" type=\"{}\">{}</script>\n", id, type, text);
}

}  // namespace

std::string report_page(const ReportPage& report, int threads) {
  const std::vector<std::string> methods = methods_of(report);
  Json rows = Json::array();
  std::string chunk, chunks;
  size_t chunk_count = 0;
  const auto close_chunk = [&] {
    if (chunk.empty()) return;
    chunks += script_element(fmt::format("details-{}", chunk_count++), "text/plain",
                             gzip_base64("[" + chunk + "]"));
    chunk.clear();
  };
  run_in_order<CaseText>(
      report.cases.size(), threads,
      [&](size_t i) {
        return describe(report.cases[i], methods, report.cases.size() <= kFewCases);
      },
      [&](const CaseText& text) {
        chunk += (chunk.empty() ? "" : ",") + text.details;
        rows.push_back(text.row);
        if (rows.size() % kCasesPerChunk == 0) close_chunk();
      });
  close_chunk();

  Json groups = Json::array(), tables = Json::array();
  for (const Row& row : report.rows) groups.push_back(row_json(row));
  for (const ReportTable& table : report.tables) {
    tables.push_back({{"id", table.id},
                      {"title", table.title},
                      {"columns", table.table.titles()},
                      {"rows", table.table.texts()}});
  }
  const Json data = {{"format", "ccdfuzz-report"},
                     {"version", 1},
                     {"title", report.title},
                     {"command", report.command},
                     {"methods", methods_json(methods)},
                     {"groups", groups},
                     {"paper", paper_json(report.rows, methods)},
                     {"tables", tables},
                     {"course", course_json(report.course)},
                     {"curvature", report.curvatures.bins()},
                     {"cases", rows},
                     {"cases_left_out", report.cases_left_out},
                     {"cases_per_chunk", kCasesPerChunk}};

  const std::string_view page = report_template();
  const size_t mark = page.find(kReportDataMark);
  CCDFUZZ_VERIFY(mark != std::string_view::npos);
  std::string out(page.substr(0, mark));
  out += script_element("report", "application/json", script_safe(json_text(data)));
  if (!report.scoreboard.empty()) {
    out += script_element("scoreboard", "application/json", script_safe(report.scoreboard));
  }
  out += chunks;
  out += page.substr(mark + kReportDataMark.size());
  return out;
}

}  // namespace ccdfuzz
