#include <fmt/format.h>

#include "cli/answer_row.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
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

/// The work of an answer is its pops times this: measured, a pair of boxes of two patches with n
/// control points together takes about 15·n·(n + 100) ns with the methods of the paper, 0.63 ms for
/// two tensor(8,8) and 0.02 ms for two triangle(2). tdibm-c takes an eighth or less of that;
/// tdibm-rational as much, and Answer::work where doubles do not decide.
std::uint64_t work_of_a_pop(const Query& query) {
  const std::uint64_t points =
      query.patches[0].positions.size() + query.patches[1].positions.size();
  return points * (points + 100);
}

/// What a run may do where no --max-pops is given, on every machine and number of threads alike.
class DefaultBudget {
 public:
  /// Limits an answer, so that all default methods together take about 5 s on two close patches
  /// that none can decide.
  static void limit(SearchOptions& search, const Query& query) {
    const std::uint64_t pops = kWorkOfAnAnswer / work_of_a_pop(query);
    const std::uint64_t most = std::clamp<std::uint64_t>(pops, 1, SearchOptions().max_pops);
    search.max_pops = search.max_pops == 0 ? most : std::min(search.max_pops, most);
    search.max_work = kWorkOfAnAnswer * kExactWork;
  }

  void add(const Query& query, const Answer& answer) {
    work_ += answer.pops * work_of_a_pop(query) + answer.work / kExactWork;
    ++answers_;
  }
  bool is_spent() const { return work_ >= kWorkOfARun + answers_ * kCreditOfAnAnswer; }

 private:
  static constexpr std::uint64_t kWorkOfAnAnswer = 40'000'000;  // times 15 ns: 0.6 s
  static constexpr std::uint64_t kExactWork = 12;  // takes as long: measured, 9 to 24 ns
  /// A run may take this and kCreditOfAnAnswer for each answer given, so that a file of many of the
  /// costliest cases ends, too: about 20 s and 0.05 s an answer. Ordinary data sets stay below:
  /// measured, an answer takes 17,000 in the mean for VV RP and 2,200,000 for FF RN of triangle(2).
  /// It takes 6,500,000 for FF RN of tensor(8,8), of which 50 cases are within.
  static constexpr std::uint64_t kDefaultMethodCount = 7;
  static constexpr std::uint64_t kWorkOfARun = 4 * kDefaultMethodCount * kWorkOfAnAnswer;
  static constexpr std::uint64_t kCreditOfAnAnswer = kWorkOfAnAnswer / 12;

  std::uint64_t work_ = 0, answers_ = 0;
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
        budget.add(named.value.query, judged.answer);
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
  if (!first_left.empty()) {
    throw BadInput{{first_left,
                    "this case and all after it are left undecided: the default budget of a run, "
                    "about 20 s of counted work and 0.05 s an answer, is spent; --max-pops N sets "
                    "one for each answer instead"}};
  }
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
