#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/default_budget.hpp"
#include "cli/session.hpp"
#include "eval/tally.hpp"
#include "finds/failure.hpp"

namespace ccdfuzz {

namespace {

struct QueryOptions {
  std::vector<std::string> files;
  std::vector<std::string> methods = default_methods();
  SearchFlags search;
};

/// The exact number, or where that is long a double next to it.
std::string time_text(const Rational& t) {
  constexpr size_t kLong = 20;
  const std::string text = to_text(t);
  return text.size() <= kLong ? text : fmt::format("{}", t.get_d());
}

/// "tensor(2,1)", "one-sided mesh of 2 triangles".
std::string shape_text(const MovingPatch<double>& patch) {
  if (patch.faces.empty()) return to_text(patch.shape);
  return fmt::format("{}mesh of {}", patch.one_sided ? "one-sided " : "",
                     counted(patch.faces.size(), "triangle", "triangles"));
}

/// A case to ask about, and its checked truth.
std::string heading_of(const NamedCase& named) {
  const auto& [query, truth, origin, asked, expect] = named.value;
  std::string known = "nothing is known of a contact";
  if (const std::optional<Rational> by = truth.contact_by()) {
    known = "contact by t = " + time_text(*by);
    // Shrinking may move a contact of bodies to other features.
    if (!origin.contact.empty()) {
      known = is_of_bodies(query)
                  ? fmt::format("{}, drawn as {}", known, origin.contact)
                  : fmt::format("contact {} by t = {}", origin.contact, time_text(*by));
    }
  } else if (truth.collides) {
    known = *truth.collides ? "contact" : "no contact";
  }
  return fmt::format("{}\n{}", named.id,
                     wrapped(fmt::format("{} and {}, t_max {}: {}", shape_text(query.patches[0]),
                                         shape_text(query.patches[1]), query.t_max, known),
                             2));
}

std::vector<TableCell> query_cells(const std::string& method, const Judged& judged) {
  const Answer& answer = judged.answer;
  const bool bad = is_false_negative(judged.outcome) || judged.outcome == Outcome::kError;
  std::string at;
  if (answer.has_toi()) {
    constexpr size_t kMost = 18;  // of what the width of a terminal leaves
    at = fmt::format(" at {}", *answer.toi);
    if (at.size() > kMost + 4) at = fmt::format(" at {:.10g}", *answer.toi);
  }
  const bool is_asked = judged.outcome != Outcome::kNotAsked;
  // An answer that is nonsense has a verdict that is judged; a crash or a hang is none.
  const bool is_answered = !(judged.outcome == Outcome::kError && judged.error != "nonsense");
  std::string outcome = to_text(judged.outcome, judged.late_by);
  outcome += wrong_by(judged);
  return {{marked(method)},
          {is_answered ? std::string(name_of(answer.verdict)) + at : judged.error},
          {outcome, bad},
          {is_asked && is_answered ? fmt::format("{}", answer.pops) : "-"},
          {is_asked ? duration_text(answer.seconds) : "-"}};
}

constexpr size_t kMostNotes = 5;

/// Appends the notes about the answers to a case, each with all methods that it is of.
void add_notes(std::vector<std::string>& notes, const std::string& id,
               const std::vector<std::string>& methods, const std::vector<Judged>& answers) {
  std::map<std::string, std::vector<std::string>> by_text;
  for (size_t m = 0; m < answers.size(); ++m) {
    const std::string &error = answers[m].error, &note = answers[m].answer.note;
    const bool both = !error.empty() && !note.empty();
    by_text[error + (both ? ": " : "") + note].push_back(methods[m]);
  }
  by_text.erase("");
  for (const auto& [text, of] : by_text) {
    if (notes.size() > kMostNotes) return;
    notes.push_back(wrapped(fmt::format("{}, {}: {}", id, fmt::join(of, ", "), text), 2) + "\n");
  }
}

/// "12 correct, 1 missed".
std::string outcomes_text(const Tally& tally) {
  std::string text;
  for (const Outcome outcome : kAllOutcomes) {
    if (tally.count(outcome) == 0) continue;
    text +=
        fmt::format("{}{} {}", text.empty() ? "" : ", ", tally.count(outcome), to_text(outcome));
  }
  return text;
}

int run_query(const QueryOptions& options, Session& session) {
  const bool is_default = options.methods == default_methods();
  // Those by default take no bodies.
  const auto methods_for = [&](const Case& value) {
    return is_default && is_of_bodies(value.query) ? std::vector<std::string>{"oracle"}
                                                   : options.methods;
  };
  const bool by_default = !options.search.max_pops;
  session.begin_table(
      {method_column(), {"answer", Align::kLeft}, {"outcome", Align::kLeft}, {"pops"}, {"time"}});
  tbb::enumerable_thread_specific<MethodSet> methods;
  DefaultBudget budget;
  std::vector<std::string> notes;
  Tally tally;
  bool may_need_more = false;  // pops, for what is undecided
  session.each_case<std::vector<Judged>>(
      CaseStream(options.files),
      [&](NamedCase& named) {
        std::vector<Judged> answers;
        const CheckedCase asked = need(decided_and_checked(named));
        const SearchOptions search = options.search.options_for(named.value);
        for (const std::string& method : methods_for(named.value)) {
          Judged& judged = answers.emplace_back(ask(methods.local()[method], asked, search));
          judged.depth = depth_of(asked, judged).value_or(0);
        }
        return answers;
      },
      [&](const NamedCase& named, const std::vector<Judged>& answers) {
        if (by_default) budget.begin(named);
        session.start_group(heading_of(named));
        const std::uint64_t most = options.search.options_for(named.value).max_pops;
        const std::vector<std::string> asked = methods_for(named.value);
        add_notes(notes, named.id, asked, answers);
        for (size_t m = 0; m < answers.size(); ++m) {
          const Judged& judged = answers[m];
          budget.add(named, judged.answer);
          tally.add(judged.answer, judged.outcome, std::nullopt);
          // The oracle ends earlier on bodies that turn where no number of pops decides.
          may_need_more =
              may_need_more || (judged.outcome == Outcome::kUndecided &&
                                (!is_of_bodies(named.value.query) || judged.answer.pops >= most));
          session.show(
              [&](auto& row) {
                row("case", named.id);
                row("method", asked[m]);
                Judged::fields(row, judged);
              },
              [&] { return query_cells(asked[m], judged); });
        }
      });
  session.note_truths();
  session.end_table(true);
  if (!session.json && session.counts.cases > 0) {
    for (size_t i = 0; i < std::min(notes.size(), kMostNotes); ++i) print_out(notes[i]);
    if (notes.size() > kMostNotes) print_out("More of the kind are in the rows of --json\n");
    print_out(mark_note(options.methods));
    if (by_default && may_need_more) {
      print_out(
          fmt::format("A larger budget than the default, 5 s a case, may decide: --max-pops {}\n",
                      SearchOptions().max_pops));
    }
    print_out(fmt::format("{}, {}: {}\n", counted(session.counts.cases, "case", "cases"),
                          counted(tally.n + tally.not_asked(), "answer", "answers"),
                          outcomes_text(tally)));
  }
  return session.exit_code(kDone);
}

}  // namespace

void add_query(CommandLine& line) {
  auto [command, options] =
      line.add<QueryOptions>("query", "Run methods on cases and judge their answers", run_query);
  command.example("what two methods say of a find",
                  "query finds/FIND.json --methods tdibm,tdibm-c");
  command.texts("case", options->files, "Case files: .json, .jsonl, .jsonl.zst or .csv").required();
  add_methods(command, options->methods,
              "Methods to run, separated by commas; where it is left out, bodies are for oracle");
  options->search.max_pops.reset();
  options->search.add_to(command);
  command.max_work();
  command.threads();
  command.json("One JSON object per answer and line, with all numbers");
}

}  // namespace ccdfuzz
