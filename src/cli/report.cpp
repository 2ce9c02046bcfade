#include "report/report.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <filesystem>

#include "base/number_text.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/hunt_page.hpp"
#include "cli/session.hpp"
#include "eval/evaluate.hpp"
#include "eval/tables.hpp"
#include "finds/entries.hpp"
#include "io/fields.hpp"
#include "io/input_bytes.hpp"
#include "io/line_reader.hpp"
#include "io/run_file.hpp"
#include "method/method.hpp"
#include "report/rows.hpp"

namespace ccdfuzz {

namespace {

struct ReportArguments {
  std::string source = "corpus";
  std::string scoreboard;
  std::string folder;
};

ReportPage report_corpus(const ReportArguments& options, Session& session) {
  ReportPage report;
  report.title = fmt::format("Corpus {}", options.source);
  NotAllowed left_out;
  tbb::enumerable_thread_specific<MethodSet> methods;
  session.each_case<ReportedCase>(
      CaseStream(need(corpus_files(options.source))),
      [&](const NamedCase& entry) { return need(reported_entry(entry, methods.local())); },
      [&](const NamedCase&, ReportedCase reported) {
        for (const GivenAnswer& answer : reported.answers) {
          if (!is_admitted(answer.method)) ++left_out[answer.method];
        }
        report.cases.push_back(std::move(reported));
      });
  if (!left_out.empty()) session.remark("{}", to_text(left_out));
  keep_most_telling(report);
  return report;
}

/// The folder of `evaluate -o`: its cases and the answers to them, side by side.
ReportPage report_run(const ReportArguments& options, Session& session) {
  RunLines answers = need(RunLines::open(answers_path(options.source)));
  const RunHeader& header = answers.header();
  SearchFlags search;
  const auto precision = header.asked.find("--precision");
  if (precision != header.asked.end()) {
    search.precision = need(parse_number(answers.where(), precision->second));
  }
  for (const std::string& file : header.inputs) need(refuse_irregular(file));
  Rows rows;
  ReportRows shown;
  MethodSet none;
  session.each_case<EvaluatedCase>(
      CasesToEvaluate(header.inputs, header.shard, &answers),
      [&](CaseToEvaluate& item) {
        if (item.line) return need(evaluated(item, {}, none));
        throw BadInput{{answers_path(options.source), "has no line of " + item.id}};
      },
      [&](const CaseToEvaluate& item, const EvaluatedCase& answered) {
        rows.add(answered);
        shown.add(answered, item.value, search.options_for(item.value).precision);
      });
  const std::vector<GenerationCost> costs = need(read_costs(header.inputs));
  ReportPage report;
  report.title = fmt::format("Evaluation in {}", options.source);
  shown.finish(report, rows, costs);
  return report;
}

ReportPage report_source(const ReportArguments& options, Session& session) {
  std::error_code error;
  if (!std::filesystem::is_directory(options.source, error)) {
    throw BadInput{
        {options.source, "is no folder; `evaluate FILE --report DIR` shows a file of cases"}};
  }
  return std::filesystem::exists(answers_path(options.source), error)
             ? report_run(options, session)
             : report_corpus(options, session);
}

/// The text of a PREFIX.json of ccdfuzz-scoreboard. Errors: naming the file and the field.
Result<std::string> read_scoreboard(const std::string& path) {
  constexpr size_t kLongest = 16 << 20;  // a run of 200 faults has 0.2 MB
  CCDFUZZ_TRY(std::string json, read_text(path, kLongest));
  return read_json_text(json, path,
                        [](const JsonCursor& top) {
                          JsonReader(top).format("ccdfuzz-scoreboard", 1, 1);
                          for (const char* list : {"drivers", "rows"}) top.at(list).array();
                        })
      .map([&] { return std::move(json); });
}

int run_report(const ReportArguments& options, Session& session) {
  std::string scoreboard;
  if (!options.scoreboard.empty()) scoreboard = need(read_scoreboard(options.scoreboard));
  ReportPage report = report_source(options, session);
  if (session.interrupted()) {
    return session.end_early(options.folder + "/index.html was not written");
  }
  report.scoreboard = std::move(scoreboard);
  report.command = command_line();
  need(write_report(report, options.folder, session.threads));
  print_out(fmt::format("{}/index.html: {}\n", options.folder,
                        counted(report.cases.size(), "case", "cases")));
  return kDone;
}

}  // namespace

void add_report(CommandLine& line) {
  auto [command, options] = line.add<ReportArguments>(
      "report", "Write a page with figures, tables and 3-D views", run_report);
  command.example("a corpus", "report corpus -o page");
  command.text(
      "source", options->source,
      "A corpus (its entries and what they expect), or the folder of an `evaluate -o`, whose "
      "numbers are taken as they are");
  command.plugin_names();
  command.allow_plugins();
  command.group("Results");
  command.text("-o,--output FOLDER", options->folder, "Folder for index.html").required();
  command.text("--scoreboard FILE", options->scoreboard,
               "Also show how the tests fare with planted faults: a .json that "
               "`ccdfuzz-scoreboard --tables` wrote");
  command.max_work();
  command.threads();
}

}  // namespace ccdfuzz
