#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include "certify/checker/check_case.hpp"
#include "cli/answer_row.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/in_order.hpp"
#include "eval/table.hpp"

namespace ccdfuzz {

namespace {

struct QueryArguments {
  std::vector<std::string> files;
  std::string methods = kDefaultMethods;
  SearchFlags search;
  int threads = 1;
  bool json = false;
};

std::vector<TableCell> table_row(const std::string& case_id, const std::string& method,
                                 const Judged& judged) {
  const Answer& answer = judged.answer;
  const bool bad = is_false_negative(judged.outcome) || judged.outcome == Outcome::kError;
  return {{case_id},
          {method},
          {std::string(name_of(answer.verdict))},
          {answer.has_toi() ? fmt::format("{}", *answer.toi) : ""},
          {std::string(name_of(judged.outcome)), bad ? Emphasis::kBad : Emphasis::kPlain},
          {fmt::format("{}", answer.pops)},
          {duration_text(answer.seconds)},
          {judged.error.empty() ? answer.note : judged.error + ": " + answer.note}};
}

Result<int> run_query(const QueryArguments& options) {
  const Result<std::vector<std::string>> methods = parse_method_list(options.methods);
  if (!methods) return tl::unexpected(methods.error());
  if (const auto search = options.search.parse(); !search) return tl::unexpected(search.error());
  const Result<std::vector<NamedCase>> cases = read_all(options.files);
  if (!cases) return tl::unexpected(cases.error());
  std::vector<SearchOptions> searches;
  std::vector<CheckedCase> checked;
  for (const NamedCase& named : *cases) {
    Result<CheckedCase> known = check_case(named);
    if (!known) return tl::unexpected(known.error());
    checked.push_back(*std::move(known));
    const Result<SearchOptions> own = options.search.parse_for(named);
    if (!own) return tl::unexpected(own.error());
    searches.push_back(*own);
  }

  Table table({{"case", Align::kLeft},
               {"method", Align::kLeft},
               {"verdict", Align::kLeft},
               {"toi", Align::kLeft},
               {"outcome", Align::kLeft},
               {"pops"},
               {"time"},
               {"note", Align::kLeft}});
  Progress progress;
  tbb::enumerable_thread_specific<MethodSet> method_sets;
  const size_t total = cases->size() * methods->size();
  size_t done = 0;
  run_in_order<Judged>(
      total, options.threads,
      [&](size_t i) {
        return ask(method_sets.local()[(*methods)[i % methods->size()]],
                   checked[i / methods->size()], searches[i / methods->size()]);
      },
      [&](const Judged& judged) {
        const std::string& id = (*cases)[done / methods->size()].id;
        const std::string& method = (*methods)[done % methods->size()];
        ++done;
        if (options.json) {
          print_json(answer_row(id, method, judged));
        } else {
          if (done % methods->size() == 1 % methods->size()) table.start_group();
          table.add_row(table_row(id, method, judged));
        }
        progress.show(static_cast<double>(done) / static_cast<double>(total), id, done, "answers");
      });
  progress.clear();
  note_words(*cases, "query");
  if (!options.json) print_table(table);
  return kDone;
}

}  // namespace

void add_query(CommandLine& line) {
  auto [command, options] =
      line.add<QueryArguments>("query", "Answer and judge single cases", run_query);
  command.texts("case", options->files, "Case files: .json, .jsonl or .jsonl.zst").required();
  command.text("--methods", options->methods, "Methods to ask, separated by commas");
  options->search.add_to(command);
  add_threads(command, options->threads);
  command.flag("--json", options->json, "One JSON object per answer and line");
}

}  // namespace ccdfuzz
