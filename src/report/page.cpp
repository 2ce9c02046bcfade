#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/verify.hpp"
#include "case/taxonomy.hpp"
#include "ccd/witness_trace/loss_signature.hpp"
#include "eval/paper_rates.hpp"
#include "files/case_json.hpp"
#include "files/test_snippet.hpp"
#include "finds/content_address.hpp"
#include "finds/failure.hpp"
#include "io/fields.hpp"
#include "io/in_order.hpp"
#include "method/method.hpp"
#include "report/loss.hpp"
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

/// The value as one line of JSON, without its end. Bytes that are not UTF-8, as file names may
/// have them, become U+FFFD: whatever they are is shown, not refused.
std::string json_text(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The number as a text of `digits` digits says it: shorter, for what is only drawn.
double shortened(double x, int digits = 6) {
  return std::strtod(fmt::format("{:.{}g}", x, digits).c_str(), nullptr);
}

/// x − t, rounded once.
double from(const Rational& t, double x) {
  return Rational(exact(x) - t).get_d();
}

Json or_null(const auto& x) {
  return x ? Json(*x) : Json();
}

Json pair_of(double a, double b) {
  return Json::array({a, b});
}

Json cells_json(const TracePlace& place) {
  Json cells = Json::array();
  for (const Cell& cell : place.cells) {
    cells.push_back(Json::array({cell.i, cell.j, cell.inverted ? 1 : 0}));
  }
  return cells;
}

Json axis_json(const ExcludedInterval& by) {
  return {{"axis", by.axis},
          {"direction", {by.direction[0], by.direction[1], by.direction[2]}},
          {"below", by.below},
          {"excluded", {by.times.lo, by.times.hi}},
          {"cut", {by.times.has_lo, by.times.has_hi}}};
}

Json loss_json(const Case& known, const Trace::Loss& loss) {
  Json row = {{"level", loss.place.level},
              {"cells", cells_json(loss.place)},
              {"window", pair_of(loss.place.window.lo, loss.place.window.hi)},
              {"left", loss.left ? pair_of(loss.left->lo, loss.left->hi) : Json()}};
  if (loss.by.axis < 0) return row;
  row.update(axis_json(loss.by));
  const LossFacts facts = facts_of(known.query, *known.truth.witness, loss);
  row["overlap"] = facts.overlap ? Json(facts.overlap->length) : Json();
  row["height_ulp"] = facts.overlap ? Json(facts.overlap->height_ulp) : Json();
  row["ulps_past"] = or_null(facts.ulps_past);
  return row;
}

/// [level, window from t*, to t*, cells, ulps, axis, direction, below, excluded from t*]
Json step_json(const Rational& t, const Trace::Step& step) {
  Json row = Json::array(
      {step.place.level,
       pair_of(shortened(from(t, step.place.window.lo)), shortened(from(t, step.place.window.hi))),
       cells_json(step.place), nullptr, nullptr, nullptr, nullptr, nullptr});
  if (!step.margin) return row;
  const ExcludedInterval& by = step.margin->by;
  row[3] = shortened(static_cast<double>(step.margin->ulps), 4);
  row[4] = by.axis;
  row[5] = Json::array();
  for (int k = 0; k < 3; ++k) row[5].push_back(shortened(by.direction[k], 7));
  row[6] = by.below;
  row[7] = pair_of(shortened(from(t, by.times.lo)), shortened(from(t, by.times.hi)));
  return row;
}

Json trace_json(const Case& known, const std::string& method, const Trace& trace) {
  Json row = {{"method", method}, {"lost", trace.lost}, {"levels", trace.levels}};
  if (trace.loss) row["loss"] = loss_json(known, *trace.loss);
  if (trace.margin) {
    row["margin"] = {{"level", trace.margin->place.level}, {"ulps", trace.margin->ulps}};
  }
  row["steps"] = Json::array();
  for (const Trace::Step& step : trace.steps) {
    row["steps"].push_back(step_json(known.truth.witness->t, step));
  }
  return row;
}

/// [method, level, axis, ulps in time]
Json worst_json(const std::string& method, const Json& loss) {
  return Json::array(
      {method, loss["level"], loss.value("axis", -1), loss.value("ulps_past", Json())});
}

/// The steps' cells are the same for every method that follows the same path: each is written once.
void share_cells(Json& traces, Json& cells) {
  for (Json& trace : traces) {
    for (Json& step : trace["steps"]) {
      const auto level = step[0].get<size_t>();
      while (cells.size() <= level) cells.push_back(nullptr);
      if (cells[level].is_null()) cells[level] = step[2];
      if (cells[level] == step[2]) step[2] = nullptr;
    }
  }
}

/// c correct, m missed, l late, f false positive, u undecided, ? unknown, e error, - not asked.
char letter_of(Outcome outcome) {
  constexpr std::string_view kLetters = "cmlfu?e-";
  static_assert(kLetters.size() == kAllOutcomes.size());
  return kLetters[static_cast<size_t>(outcome)];
}

/// One case on the page: a short row for lists, and the details that its viewer reads
/// when the case is opened.
struct CaseText {
  Json row;
  std::string details;  ///< JSON
};

/// Traces the witness of the case, if it has one within t_max, through every method that failed on
/// it. With trace_all, or if none failed, through all that were asked. Plug-ins are not traced.
/// The row: [id, class, kind, generator, outcomes, new, worst, setting, bits, causes]:
/// - `outcomes` has a letter for each method ("-" where it was not asked);
/// - `worst` is the first loss of a failed method, [method, level, axis, ulps or null], or null;
/// - `bits` are the query's significant bits (CaseSize);
/// - `causes` maps methods that failed to the cause: the one that the case expects, or the trace's.
CaseText describe(const ReportedCase& reported, const std::vector<std::string>& methods,
                  bool trace_all) {
  const Case& known = reported.value;
  const bool failed = reported.has_failure();
  const auto& witness = known.truth.witness;
  const bool traceable = witness && witness->t <= exact(known.query.t_max);
  std::string outcomes(methods.size(), '-');
  Json answers = Json::object(), traces = Json::array(), causes = Json::object(), worst;
  for (const Failure& failure : failures_of(known)) {
    if (!failure.cause.empty()) causes[failure.who] = failure.cause;
  }
  for (const GivenAnswer& answer : reported.answers) {
    const auto at = std::ranges::find(methods, answer.method);
    if (at == methods.end()) continue;
    outcomes[static_cast<size_t>(at - methods.begin())] = letter_of(answer.outcome);
    answers[answer.method] = {{"outcome", name_of(answer.outcome)}, {"toi", or_null(answer.toi)}};
    if (!traceable || (failed && !trace_all && !is_failure(answer.outcome))) continue;
    if (answer.outcome == Outcome::kError || answer.outcome == Outcome::kNotAsked) {
      continue;  // it would do here what it did there
    }
    const auto method = make_method(answer.method);
    if (!method || !(*method)->is_traceable() || is_of_bodies(known.query))
      continue;  // a plug-in, of which nothing is seen but its answer
    const Trace& traced =
        (*method)->trace(known.query, *witness, {reported.precision, false, true});
    traces.push_back(trace_json(known, answer.method, traced));
    const Json& trace = traces.back();
    if (!is_failure(answer.outcome)) continue;
    causes.emplace(answer.method, loss_cause(traced));
    if (worst.is_null() && trace.contains("loss")) worst = worst_json(answer.method, trace["loss"]);
  }
  Json cells = Json::array();
  share_cells(traces, cells);
  constexpr TestFramework kGoogleTest = TestFramework::kGoogleTest;
  const Result<std::string> test = test_snippet({reported.id, known}, 1, kGoogleTest);
  const Json details = {
      {"reproduce", reported.reproduce},
      {"gtest", test ? test_preamble(kGoogleTest) + *test : "// " + test.error().message() + "\n"},
      {"answers", answers},
      {"cells", cells},
      {"traces", traces}};
  const Origin& origin = known.origin;
  std::string text = json_text(details);
  text.pop_back();
  return {Json::array({reported.id, origin.contact, origin.kind, origin.generator, outcomes,
                       or_null(reported.is_new), worst, name_of(setting_of(known)),
                       size_of(known.query).significant_bits, causes}),
          text + ",\"case\":" + to_json(known) + "}"};
}

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
Json course_json(const ReportPage& report) {
  if (report.course.empty()) return nullptr;
  Json samples = Json::array();
  for (const HuntSample& s : report.course) {
    Json margins = Json::array();
    for (const auto& margin : s.margins) margins.push_back(or_null(margin));
    samples.push_back(Json::array({s.seconds, s.queries, s.mutants, s.finds, margins}));
  }
  return {{"methods", report.hunted}, {"samples", samples}};
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
                      {"note", table.note},
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
                     {"course", course_json(report)},
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
