#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include "base/table.hpp"
#include "cli/answer_row.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/output.hpp"
#include "cli/shared_case.hpp"
#include "cli/terminal.hpp"
#include "eval/stream_cases.hpp"

namespace ccdfuzz {

namespace {

struct QueryArguments {
  std::vector<std::string> files;
  std::string methods = kDefaultMethods;
  SearchFlags search;
  int threads = 1;
  bool json = false;
};

/// The work of an answer is its pops times this: measured, a pair of boxes of two patches with n
/// control points together takes about 15·n·(n + 100) ns with the methods of the paper, 0.63 ms for
/// two tensor(8,8) and 0.02 ms for two triangle(2). tdibm-c takes an eighth or less of that;
/// tdibm-rational as much, and more where its numbers grow long.
std::uint64_t work_of_a_pop(const Query& query) {
  const std::uint64_t points =
      query.patches[0].positions.size() + query.patches[1].positions.size();
  return points * (points + 100);
}

/// Pairs of boxes that a method may look at where no --max-pops is given, so that all default
/// methods together take about 5 s on two close patches that none can decide, and the same on every
/// machine.
constexpr std::uint64_t kWorkOfAnAnswer = 40'000'000;  // times 15 ns: 0.6 s
constexpr std::uint64_t kDefaultMethodCount = 7;
std::uint64_t default_pops(const Query& query) {
  const std::uint64_t pops = kWorkOfAnAnswer / work_of_a_pop(query);
  return std::clamp<std::uint64_t>(pops, 1, SearchOptions().max_pops);
}

/// A run may take this and kCreditOfAnAnswer for each answer given, so that a file of many of the
/// costliest cases ends, too: about 20 s and 0.05 s an answer. Ordinary data sets stay below:
/// measured, an answer takes 17,000 in the mean for VV RP and 2,200,000 for FF RN of triangle(2).
/// It takes 6,500,000 for FF RN of tensor(8,8), of which 50 cases are within.
constexpr std::uint64_t kWorkOfARun = 4 * kDefaultMethodCount * kWorkOfAnAnswer;
constexpr std::uint64_t kCreditOfAnAnswer = kWorkOfAnAnswer / 12;

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
  std::uint64_t done = 0, undecided = 0, work = 0;
  std::string first_left;  // the first case for which no work is left
  std::atomic<bool> stop = false;
  WordCount words;
  const Result<void> read = stream_cases<SharedCase, Judged>(
      options.files, methods->size(), options.threads,
      [&](SharedCase& shared, size_t m) -> Result<Judged> {
        if (stop) return Judged();  // is not shown
        const Result<CheckedCase>& asked = shared.checked();
        if (!asked) return tl::unexpected(asked.error());
        Result<SearchOptions> search = options.search.parse_for(shared.named());
        if (!search) return tl::unexpected(search.error());
        const std::string& method = (*methods)[m];
        if (search->max_pops == 0) search->max_pops = default_pops(asked->query());
        return ask(method_sets.local()[method], *asked, *search);
      },
      [&](const SharedCase& shared, size_t m, const Judged& judged, double share) {
        const std::string& id = shared.named().id;
        const std::string& method = (*methods)[m];
        if (m == 0 && !stop && options.search.max_pops == 0 &&
            work >= kWorkOfARun + done * kCreditOfAnAnswer) {
          first_left = id;
          stop = true;
        }
        if (stop) return;
        work += judged.answer.pops * work_of_a_pop(shared.named().value.query);
        ++done;
        if (m == 0) words.add(shared.named().value);
        if (judged.answer.verdict == Verdict::kUndecided && judged.error.empty()) ++undecided;
        if (options.json) {
          print_json(answer_row(id, method, judged));
        } else {
          if (m == 0) {
            print_full_rows(table);
            table.start_group();
          }
          table.add_row(table_row(id, method, judged));
        }
        progress.show(share, id, done, "answers");
      },
      &stop);
  progress.clear();
  words.note("query");
  if (table.row_count() > 0) print_last_rows(table);
  if (!read && first_left.empty()) return tl::unexpected(read.error());
  if (!options.json && undecided > 0 && options.search.max_pops == 0) {
    print_out(
        fmt::format("\n{} of {} answers undecided, most often for want of the default budget of "
                    "about 5 s a case; more: --max-pops {}\n",
                    undecided, done, SearchOptions().max_pops));
  }
  if (!first_left.empty()) {
    return input_error(first_left,
                       "this case and all after it are left undecided: the default budget of a "
                       "run, about 20 s of counted work and 0.05 s an answer, is spent; "
                       "--max-pops N sets one for each answer instead");
  }
  return kDone;
}

}  // namespace

void add_query(CommandLine& line) {
  auto [command, options] =
      line.add<QueryArguments>("query", "Answer and judge single cases", run_query);
  command.texts("case", options->files, "Case files: .json, .jsonl or .jsonl.zst").required();
  command.text("--methods", options->methods, "Methods to ask, separated by commas");
  options->search.max_pops = 0;  // default_pops
  options->search.add_precision_to(command);
  options->search.add_budget_to(command).front().without_default();
  add_threads(command, options->threads);
  command.flag("--json", options->json, "One JSON object per answer and line");
}

}  // namespace ccdfuzz
