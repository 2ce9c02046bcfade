#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "certify/oracle/body_depth.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/default_budget.hpp"
#include "cli/replay_changes.hpp"
#include "cli/session.hpp"
#include "files/case_json.hpp"
#include "files/expected_json.hpp"
#include "finds/claim_files.hpp"
#include "finds/entries.hpp"
#include "finds/failure.hpp"
#include "hunt/ground.hpp"
#include "hunt/served_claim.hpp"
#include "method/plugin/plugin_spec.hpp"
#include "method/served_method.hpp"

namespace ccdfuzz {

namespace {

struct ReplayOptions {
  std::string corpus = "corpus";     ///< folder that Store::put writes to, or a file of cases
  std::vector<std::string> methods;  ///< empty: those that an entry names
  std::optional<Outcome> expect;     ///< for every method, in place of what an entry says
  bool update = false;
  SearchFlags search;
};

/// An expectation of an entry and what was got, as a row of the table and of the JSON output.
struct ReplayRow {
  std::string id;  ///< the entry's
  std::string method;
  Expected expected, got;
  Judged judged;
  bool differs;  ///< the method shows something else when it is asked again

  Change change() const { return change_of(expected, got); }
  /// A clock told that it hangs.
  bool hangs_anew() const { return judged.error == "hang" && change() != Change::kNone; }

  static void fields(auto& archive, auto& row) {
    archive("case", row.id);
    archive("method", row.method);
    Judged::fields(archive, row.judged);
    archive("got", row.got);
    archive("expected", row.expected);
    archive("change", row.change());
  }
};

/// The same of a claim that was put to its input again.
Change change_of(Check::Status expected, Check::Status got) {
  if (got == expected) return Change::kNone;
  if (got == Check::Status::kDiscarded) return Change::kOther;
  return got == Check::Status::kFails ? Change::kRegression : Change::kImprovement;
}

/// What asks methods, for one thread. One that is expected to end in an error is asked in another
/// process, since it may end this one. Neither is told a time.
struct Askers {
  Asker here{SearchOptions()}, served{SearchOptions(), MethodSet(make_served_method)};
};

/// The results of one entry.
struct Replayed {
  std::vector<ReplayRow> rows;
  std::map<std::string, Expected> not_allowed;
  std::map<std::string_view, std::uint64_t> left_out;  ///< answers, by why_left_out
  std::optional<InputError> not_proven;                ///< none if its truth holds
};

/// The methods to ask about an entry, and the expected outcomes.
std::map<std::string, Expected> expectations(const CheckedCase& entry,
                                             const ReplayOptions& options) {
  std::map<std::string, Expected> wanted = entry.value().expect;
  if (!options.methods.empty()) {
    std::erase_if(wanted, [&](const auto& stated) {
      return std::ranges::find(options.methods, stated.first) == options.methods.end();
    });
  }
  if (!options.expect) return wanted;
  for (const std::string& method : options.methods) wanted[method];
  for (auto& [method, expected] : wanted) expected = *options.expect;
  return wanted;
}

/// Whether the first known contact is at 0 or t_max. What is unknown of an answer is then whether
/// the method claims to find it, unless the depth of bodies with many points is.
bool is_at_end(const CheckedCase& known) {
  const auto& [a, b] = known.query().patches;
  const std::optional<Rational> by = known.contact_by();
  return by && (*by == 0 || *by == exact(known.query().t_max)) &&
         (!is_of_bodies(known.query()) || is_measured(a.positions.size(), b.positions.size()));
}

/// Whether an entry says that the method ended in an error. Any answer is what was wanted then.
bool ended_in_error(const CheckedCase& known, const std::string& method) {
  const auto& before = known.value().expect;
  const auto stated = before.find(method);
  return stated != before.end() && stated->second.outcome == Outcome::kError;
}

/// Why an answer is not held to what --expect says of all, in words behind a number; otherwise
/// empty. An unknown outcome judges nothing.
std::string_view why_left_out(const CheckedCase& known, const ReplayRow& row) {
  if (row.expected == row.got) return "";
  if (row.got.outcome == Outcome::kNotAsked) return "not asked, as the method does not take them";
  if (row.got.outcome != Outcome::kUnknown) return "";
  if (!known.collides()) return "not judged, as nothing is known of a contact (see prove)";
  if (!is_at_end(known)) return "not judged, as they may be right within the method's tolerance";
  return "left out: a contact at an end of the step, which the method does not claim to find";
}

/// Errors: throws BadInput for an entry that names no method.
Replayed replayed(NamedCase& entry, Askers& askers, const ReplayOptions& options) {
  Replayed result;
  const Result<CheckedCase> known = decided_and_checked(entry);
  if (!known) {
    result.not_proven = known.error();
    return result;
  }
  // An entry was kept with its answers, and may be one of the costly: about 10 s an answer.
  constexpr std::uint64_t kTimes = 16;
  const SearchOptions search = options.search.options_for(entry.value, kTimes);
  for (const auto& [method, expected] : expectations(*known, options)) {
    if (!is_admitted(method)) {
      result.not_allowed.emplace(method, expected);
      continue;
    }
    need_at(entry.id + ": expect", make_method(method));
    Asker& asker = expected.outcome == Outcome::kError ? askers.served : askers.here;
    Judged judged = asker.ask(method, *known, search);
    Expected got = asker.expected(method, known->value(), judged);
    const bool differs =
        change_of(expected, got) != Change::kNone && asker.differs(method, *known, got, search);
    if (options.update) judged.depth = depth_of(*known, judged).value_or(0);
    ReplayRow row{entry.id, method, expected, std::move(got), std::move(judged), differs};
    const bool is_unknown = row.got.outcome == Outcome::kUnknown;
    if (is_unknown && options.expect == Outcome::kCorrect && ended_in_error(*known, method)) {
      row.expected = row.got;
    }
    const std::string_view why = options.expect ? why_left_out(*known, row) : std::string_view();
    if (why.empty()) {
      result.rows.push_back(std::move(row));
    } else {
      ++result.left_out[why];
    }
  }
  return result;
}

class Replay {
 public:
  Replay(const ReplayOptions& options, Session& session) : options_(options), session_(session) {}

  int run() {
    session_.begin_table(
        {method_column(), {"expected", Align::kLeft}, {"got", Align::kLeft}, {"", Align::kLeft}});
    tbb::enumerable_thread_specific<Askers> askers;
    const bool of_methods = !options_.methods.empty() || options_.expect;
    const auto [cases, claims] = need(cases_and_claims(options_.corpus));
    if (cases.empty() && claims.empty()) need(corpus_files(options_.corpus));
    if (of_methods && cases.empty()) {
      throw BadInput{{options_.corpus, "has claims alone, about which no method is asked"}};
    }
    if (!of_methods) session_.unless_refused([&] { replay_claims(claims); });
    session_.each_case<Replayed>(
        CaseStream(cases),
        [&](NamedCase& entry) { return replayed(entry, askers.local(), options_); },
        [&](const NamedCase& entry, const Replayed& done) { add(entry, done); });
    session_.end_table(true);
    summarise();
    const bool holds =
        options_.update || (expectations_.all_as_expected() && claims_.all_as_expected());
    const bool passes = not_proven_ == 0 && holds && (session_.interrupted() || was_asked());
    return session_.exit_code(passes ? kDone : kCheckFailed);
  }

 private:
  /// Runs the property of each of these files on its choices, in a child. Throws BadInput for a
  /// file that is no claim, or is of a property that is not known.
  void replay_claims(const std::vector<std::string>& files) {
    ServedClaims built_in(&catch_interrupts()), of_plugins(&catch_interrupts(), true);
    for (const std::string& path : files) {
      if (session_.interrupted()) return;
      const ClaimFind find = need(read_claim(path));
      const Property claim =
          need_at(path + ": property", property_named(find.property, session_.properties));
      const Property property = need_at(path + ": method", about(claim, find.method));
      if (!find.method.empty()) {
        if (!is_admitted(find.method)) {
          ++not_allowed_[find.method];
          continue;
        }
        need_at(path + ": method", narrowed({}, {find.method}));
      }
      ServedClaims& served = names_plugin(find.method) ? of_plugins : built_in;
      const InputRun run = served.on(property, find.choices);
      if (run.error == "interrupted") return;
      const auto& [got, text] = run.check;
      const Change change = change_of(find.expect, got);
      claims_.add(change);
      const bool changed = change != Change::kNone;
      if (session_.json || changed) {
        session_.start_group(path);
        session_.show(
            [&](auto& row) {
              row("claim", path);
              row("property", find.property);
              row.optional("method", find.method);
              row("expected", find.expect);
              row("got", got);
              row("change", change);
              row.optional("text", text);
            },
            [&] {
              return change_cells(title_of(find.property, find.method), name_of(find.expect),
                                  name_of(got), change);
            });
      }
      if (!changed || !options_.update) continue;
      ClaimFind now = find;
      now.expect = got;
      claims_.update(path, file_text(now), [&] { return need(read_claim(path)) == find; });
    }
  }

  void add(const NamedCase& entry, const Replayed& done) {
    if (!options_.search.max_pops) budget_.begin(entry);
    if (done.not_proven) {
      ++not_proven_;
      const char* truth = done.not_proven->is_limit ? "unproven" : "refuted";
      const std::string note = done.not_proven->message();
      const auto row = [&](auto& archive) {
        archive("case", entry.id);
        archive("truth", std::string_view(truth));
        archive("note", note);
      };
      return session_.say(row, fmt::format("{}: {}\n", truth, note));
    }
    for (const auto& stated : done.not_allowed) {
      ++not_allowed_[stated.first];
      if (!session_.json) continue;
      print_row([&](auto& row) {
        row("case", entry.id);
        row("method", stated.first);
        row("outcome", Outcome::kNotAsked);
        row("expected", stated.second);
      });
    }
    for (const auto& [why, count] : done.left_out) left_out_[why] += count;
    session_.start_group(entry.id);
    for (const ReplayRow& row : done.rows) {
      expectations_.add(row.change());
      if (row.change() != Change::kNotAsked) asked_.insert(row.method);
      budget_.add(entry, row.judged.answer);
      if (row.differs) session_.remark("{}: {}: {}", entry.id, row.method, kAnswersDiffer);
      const bool is_other = row.change() != Change::kNone;
      if (session_.json || (is_other && ++shown_ <= kMostShown)) {
        session_.show(row, [&] {
          return change_cells(marked(row.method), to_text(row.expected),
                              to_text(row.got, row.judged.late_by), row.change());
        });
      }
    }
    if (options_.update) update(entry, done.rows);
  }

  void update(const NamedCase& entry, const std::vector<ReplayRow>& rows) {
    Case now = entry.value;
    for (const ReplayRow& row : rows) {
      if (!row.hangs_anew()) {
        // What is shown may be as --expect says, and not as the entry does.
        const bool is_kept = row.change() == Change::kNone && !options_.expect;
        if (!is_kept && row.change() != Change::kNotAsked) now.expect[row.method] = row.got;
        const bool is_right = row.judged.outcome == Outcome::kCorrect;
        if (is_right || row.judged.depth > 0) {
          say_depth(now, row.method, is_right ? Judged() : row.judged);
        }
        continue;
      }
      session_.remark("{}: {} hangs, by the clock: what the entry expects of it is left as it is",
                      entry.id, row.method);
    }
    if (now == entry.value) return;
    if (!entry.id.ends_with(".json")) {
      throw BadInput{
          {entry.id, "is a case of a data set: --update writes files of one case, .json"}};
    }
    expectations_.update(entry.id, to_json(now, JsonLayout::kReadable) + "\n", [&] {
      NamedCase stored = need(read_case(entry.id));
      decide_unknown(stored);
      return stored.value == entry.value;
    });
  }

  /// Says so where nothing was judged, or nothing by a method that --methods names: then all was as
  /// expected for no good reason.
  bool was_asked() const {
    if (asked_.empty() && claims_.total() == 0 && options_.methods.empty()) {
      session_.remark("nothing was judged: {}",
                      expectations_.total() > 0 ? "every query was refused"
                      : not_allowed_.empty()    ? "no entry expects anything"
                                                : "every expectation is one of a plug-in");
      return false;
    }
    bool all = true;
    for (const std::string& method : options_.methods) {
      if (asked_.contains(method)) continue;
      session_.remark("{} was judged by nothing: {}", method,
                      options_.expect
                          ? "no entry shows whether its answer is right"
                          : "no entry that it takes expects anything of it; see --expect");
      all = false;
    }
    return all;
  }

  void summarise() const {
    if (shown_ > kMostShown) {
      session_.summary(fmt::format("and {} more that --json lists\n", shown_ - kMostShown));
    }
    if (claims_.total() > 0) {
      session_.summary(fmt::format(
          "{}: {}", counted(claims_.total(), "input of properties", "inputs of properties"),
          claims_.text()));
    }
    std::string left_out;
    for (const auto& [why, count] : left_out_) left_out += fmt::format("; {} {}", count, why);
    const std::uint64_t entries = session_.counts.cases;
    if (entries > 0 || claims_.total() == 0) {
      session_.summary(fmt::format("{}, {}: {}{}", counted(entries, "entry", "entries"),
                                   counted(expectations_.total(), "expectation", "expectations"),
                                   expectations_.text(), left_out));
    }
    if (expectations_.count(Change::kImprovement) > 0 && !options_.update) {
      session_.remark("an improvement is a change, too: --update writes it into the entry");
    }
    if (!not_allowed_.empty()) session_.remark("{}", to_text(not_allowed_));
    session_.note_truths();
  }

  const ReplayOptions& options_;
  Session& session_;
  std::uint64_t not_proven_ = 0;
  std::map<std::string_view, std::uint64_t> left_out_;
  static constexpr std::uint64_t kMostShown = 10;  // rows of the table
  std::uint64_t shown_ = 0;
  Changes expectations_, claims_;
  DefaultBudget budget_;
  std::set<std::string> asked_;
  NotAllowed not_allowed_;
};

int run_replay(const ReplayOptions& options, Session& session) {
  return Replay(options, session).run();
}

}  // namespace

void add_replay(CommandLine& line) {
  auto [command, options] =
      line.add<ReplayOptions>("replay", "Run a corpus as regression tests", run_replay);
  command.example("whether your code is mended",
                  "replay finds --methods plugin:./libmine.so --expect correct");
  command.text("corpus", options->corpus,
               "A corpus, its `claims` alone, or a file of cases or of one claim");
  add_methods(command, options->methods, "Methods to run, by default those that an entry names");
  command.allow_plugins();
  command.choice("--expect OUTCOME", options->expect,
                 "What is expected of each method about every entry that it takes, such as "
                 "correct; by default what the entry says");
  Option update = command.flag(
      "--update", options->update,
      "Write what methods show now into the entries, with the depth, but no hang, which "
      "depends on the machine, and no refusal. What changed is then no failure");
  // An entry says itself how it is asked.
  options->search.max_pops.reset();
  for (const Option& limit : options->search.add_to(command)) update.excludes(limit);
  command.max_work();
  command.threads();
  command.json("One JSON object per expectation");
}

}  // namespace ccdfuzz
