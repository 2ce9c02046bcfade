#include "eval/evaluate.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "eval/tables.hpp"
#include "files/case_json.hpp"
#include "io/csv_writer.hpp"
#include "io/hash_name.hpp"
#include "io/input_bytes.hpp"
#include "io/output_file.hpp"
#include "io/run_file.hpp"
#include "report/rows.hpp"

namespace ccdfuzz {

namespace {

struct EvaluateArguments {
  std::vector<std::string> files;
  EvaluateOptions how;
  SearchFlags search;
  std::string shard;
  std::string folder;
  std::string csv;
  std::string page;  ///< folder
  bool by_class = false;
};

Result<double> parse_horizon(const std::string& where, const std::string& text) {
  CCDFUZZ_TRY(const double factor, parse_number(where, text));
  if (factor >= 1) return factor;
  return input_error(where, "{} is below 1: the contact would be out of reach", factor);
}

/// Reads the files once, to know which cases they hold. Another build of a plug-in is another run.
/// Errors: of reading; a file that cannot be read twice.
Result<RunHeader> header_of(const std::vector<std::string>& files,
                            const std::vector<std::string>& methods, const Session& session) {
  RunHeader header{"evaluate", CCDFUZZ_VERSION, files, session.asked, 0, {}};
  for (const std::string& method : methods) {
    if (const std::string build = build_of(method); !build.empty()) header.asked[method] = build;
  }
  for (const std::string& file : files) {
    CCDFUZZ_TRY_VOID(refuse_irregular(file));
  }
  std::string& address = header.asked["cases"];
  CaseStream cases(files);
  for (;;) {
    CCDFUZZ_TRY(const std::optional<NamedCase> next, cases.next());
    if (!next) return header;
    ++header.items;
    address = hash_name(address + to_json(next->value));
  }
}

void print_evaluation(const Rows& rows, const std::vector<GenerationCost>& costs,
                      const EvaluateArguments& arguments, std::uint64_t cases) {
  const std::vector<Row> methods = by_methods(rows);
  if (arguments.by_class) {
    for (const auto& [title, table, note] : evaluation_tables(rows, costs)) {
      print_out(fmt::format("{}:\n", title));
      print_table(table);
      print_out(note + "\n");
    }
    print_out(column_notes(methods));
  } else {
    std::vector<Row> shown = methods;
    for (Row& row : shown) row.key.method = marked(row.key.method);
    print_table(methods_table(shown));
    print_out("\n" + column_notes(methods) + mark_note(arguments.how.methods) +
              "By class, and beside the paper's tables: --by-class\n");
  }
  std::uint64_t contacts = 0, absences = 0, queries = 0;
  bool ask_all = true;
  for (const Row& row : methods) {
    contacts = std::max(contacts, row.tally.positives);
    absences = std::max(absences, row.tally.negatives);
    queries = std::max(queries, row.tally.n);
    ask_all = ask_all && row.tally.not_asked() == 0;
  }
  print_out(fmt::format("{}, {}{} a method: {} with a contact, {} without, {} not proven\n",
                        counted(cases, "case", "cases"), ask_all ? "" : "at most ",
                        counted(queries, "query", "queries"), contacts, absences,
                        queries - contacts - absences));
}

int run_evaluate(const EvaluateArguments& arguments, Session& session) {
  EvaluateOptions options = arguments.how;
  options.search_for = [&](const Case& value) { return arguments.search.options_for(value); };
  const std::vector<std::string> files = need(case_files(arguments.files));
  Shard shard;
  std::optional<RunFile> kept;
  std::optional<RunLines> earlier;
  const std::string answers = answers_path(arguments.folder);
  if (!arguments.folder.empty() || !arguments.shard.empty()) {
    RunHeader header = need(header_of(files, options.methods, session));
    shard = header.shard = need(parse_shard(arguments.shard, header.items, "cases"));
    if (!arguments.folder.empty()) {
      need(make_folder(arguments.folder));
      kept.emplace(resumed_run(header, answers, "cases"));
      earlier.emplace(need(kept->done()));
    }
  }
  if (!arguments.page.empty()) need(make_writable_folder(arguments.page));
  std::optional<OutputFile> csv;
  if (!arguments.csv.empty()) {
    leave_stdout_to(arguments.csv);
    refuse_input("--csv", arguments.csv, files, "case files");
    csv.emplace(need(OutputFile::create(arguments.csv)));
  }
  const std::vector<GenerationCost> costs = need(read_costs(files));
  Rows rows;
  ReportRows page;
  tbb::enumerable_thread_specific<MethodSet> methods;
  std::uint64_t left_out = 0;  // queries
  session.each_case<EvaluatedCase>(
      CasesToEvaluate(files, shard, earlier ? &*earlier : nullptr),
      [&](CaseToEvaluate& item) { return need(evaluated(item, options, methods.local())); },
      [&](const CaseToEvaluate& item, const EvaluatedCase& answered) {
        rows.add(answered);
        if (const size_t factors = options.horizon_factors.size();
            factors > 0 && item.value.truth.contact_by()) {
          left_out += factors - answered.answers.size() / options.methods.size();
        }
        const double precision = options.search_for(item.value).precision;
        if (!arguments.page.empty()) page.add(answered, item.value, precision);
        if (kept && is_anew(item)) need(kept->append(to_json(answered)));
      });
  int code = kDone;
  if (session.interrupted()) {
    code = session.end_early(
        session.counts.cases, "cases",
        kept ? "the same command goes on from there" : "the tables are of these alone");
    if (kept) return code;
  }
  session.note_truths();
  if (left_out > 0) {
    session.remark(
        "{} not asked: --t-max-factors end them past 1, where a motion ends, or past all doubles",
        counted(left_out, "query is", "queries are"));
  }
  if (kept) {
    need(write_tables(arguments.folder, rows, costs));
    need(kept->rename(answers));
  }
  if (csv && !session.interrupted()) {
    need(csv->write(to_csv(by_kinds(rows))));
    need(csv->commit());
  }
  if (session.json) {
    for (const Row& row : by_kinds(rows)) print_row(row);
  } else {
    print_evaluation(rows, costs, arguments, session.counts.cases);
  }
  // Last: what was measured is shown even if the page cannot be written.
  if (!arguments.page.empty() && !session.interrupted()) {
    ReportPage shown;
    shown.title = files.size() == 1 ? fmt::format("Evaluation of {}", files.front())
                                    : fmt::format("Evaluation of {} files", files.size());
    shown.command = command_line();
    page.finish(shown, rows, costs);
    need(write_report(shown, arguments.page, session.threads));
  }
  return code;
}

}  // namespace

void add_evaluate(CommandLine& line) {
  auto [command, options] = line.add<EvaluateArguments>(
      "evaluate", "Measure the accuracy and time of methods on data sets", run_evaluate);
  command.example("two methods, late answers too",
                  "evaluate vv.jsonl --methods tdibm,tdibm-c --t-max-factors 1,1.5");
  command
      .texts("dataset", options->files,
             "Case files: .json, .jsonl, .jsonl.zst, .csv (judged by their exact truth where they "
             "are linear), or folders of .csv")
      .required();
  options->how.methods = default_methods();
  add_methods(command, options->how.methods, "Methods to run, separated by commas");
  command.list("--t-max-factors LIST", options->how.horizon_factors,
               "Ask positive cases up to these multiples of the contact's time instead of their "
               "own t_max, e.g. 1,1+2^-30,1.5,2: past the contact, late answers show",
               &parse_horizon);
  options->search.add_to(command);
  command.group("Results");
  add_shard(command, options->shard);
  command.text("-o,--output FOLDER", options->folder,
               "Folder for all answers (answers.jsonl), their counts (rows.jsonl) and the tables "
               "(tables.md), which `report` shows; killed, the same command goes on where it was");
  command.text("--csv FILE", options->csv,
               "Also a CSV file with a line for each class, kinds and method; none after an "
               "interruption");
  command.text(
      "--report FOLDER", options->page,
      "Also make a page (index.html) of tables, figures and watchable failures; none after "
      "an interruption");
  command.flag("--by-class", options->by_class,
               "Tables by class and kind of cases, also beside the paper's Tables 1 to 4");
  command.json("One JSON object per class, kinds and method");
  command.max_work();
  command.threads();
}

}  // namespace ccdfuzz
