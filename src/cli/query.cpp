#include <fmt/format.h>

#include "cli/answer_row.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/default_budget.hpp"
#include "cli/session.hpp"
#include "cli/shared_case.hpp"
#include "finds/replay.hpp"

namespace ccdfuzz {

namespace {

struct QueryOptions {
  std::vector<std::string> files;
  std::vector<std::string> methods = default_methods();
  SearchFlags search;
};

std::vector<TableCell> query_cells(const AnswerRow& row) {
  const Judged& judged = row.judged;
  const Answer& answer = judged.answer;
  const bool bad = is_false_negative(judged.outcome) || judged.outcome == Outcome::kError;
  return {{row.id},
          {row.method},
          {std::string(name_of(answer.verdict))},
          {answer.has_toi() ? fmt::format("{}", *answer.toi) : ""},
          {to_text({judged.outcome, ""}, judged.late_by), bad ? Emphasis::kBad : Emphasis::kPlain},
          {fmt::format("{}", answer.pops)},
          {duration_text(answer.seconds)},
          {judged.error.empty() ? answer.note : judged.error + ": " + answer.note}};
}

int run_query(const QueryOptions& options, Session& session) {
  const bool by_default = options.search.max_pops == 0;
  session.begin_table({{"case", Align::kLeft},
                       {"method", Align::kLeft},
                       {"verdict", Align::kLeft},
                       {"toi", Align::kLeft},
                       {"outcome", Align::kLeft},
                       {"pops"},
                       {"time"},
                       {"note", Align::kLeft}});
  tbb::enumerable_thread_specific<MethodSet> methods;
  DefaultBudget budget;
  std::atomic<bool> spent = false;
  std::string first_left;  // the first case for which no work is left
  std::uint64_t done = 0, undecided = 0;
  CaseCount counts;
  session.each_case<SharedCase, Judged>(
      CaseStream(options.files), options.methods.size(), "answers",
      [&](SharedCase& shared, size_t m) {
        if (spent) return Judged();  // is not shown
        const CheckedCase& asked = need(shared.checked());
        SearchOptions search = options.search.options_for(shared.named().value);
        if (by_default) DefaultBudget::limit(search, asked.query());
        return ask(methods.local()[options.methods[m]], asked, search);
      },
      [&](const SharedCase& shared, size_t m, const Judged& judged) {
        const NamedCase& named = shared.named();
        if (m == 0 && by_default && !spent && budget.is_spent()) {
          first_left = named.id;
          spent = true;
        }
        if (spent) return;
        budget.add(named, judged.answer);
        ++done;
        if (m == 0) counts.add(named.value);
        if (judged.answer.verdict == Verdict::kUndecided && judged.error.empty()) ++undecided;
        session.show(AnswerRow{named.id, options.methods[m], judged}, m == 0, query_cells);
      },
      &spent);
  counts.note("query");
  session.end_table();
  if (undecided > 0 && by_default) {
    session.summary(
        fmt::format("\n{} of {} answers undecided, most often for want of the default budget of "
                    "about 5 s a case; more: --max-pops {}",
                    undecided, done, SearchOptions().max_pops));
  }
  if (!first_left.empty()) throw BadInput{DefaultBudget::spent_before(first_left)};
  return session.exit_code(kDone);
}

}  // namespace

void add_query(CommandLine& line) {
  auto [command, options] =
      line.add<QueryOptions>("query", "Answer and judge single cases", run_query);
  command.texts("case", options->files, "Case files: .json, .jsonl, .jsonl.zst or .csv").required();
  add_methods(command, options->methods, "Methods to ask, separated by commas");
  options->search.max_pops = 0;  // DefaultBudget
  options->search.add_precision_to(command);
  options->search.add_budget_to(command).front().without_default();
  command.threads();
  command.json("One JSON object per answer and line");
  command.max_work();
}

}  // namespace ccdfuzz
