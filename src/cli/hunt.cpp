#include "hunt/hunt.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/number_text.hpp"
#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/hunt_page.hpp"
#include "cli/session.hpp"
#include "eval/tables.hpp"
#include "files/case_json.hpp"
#include "files/expected_json.hpp"
#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

namespace {

/// TDIBM stays far below; trad alone reaches it, after about a second.
constexpr std::uint64_t kDefaultPops = 10'000;

/// The cases of one class: six times as many are still below 2^63.
constexpr std::uint64_t kMostCases = 1'000'000'000'000'000'000;

/// After which finds the command fails.
enum class FailOn : std::uint8_t { kNone, kClaims, kAny };
constexpr std::array<std::string_view, 3> names_of(FailOn) {
  return {"none", "claims", "any"};
}

struct HuntArguments {
  HuntOptions hunt;
  std::string corpus = "finds";
  FailOn fail_on = FailOn::kNone;
  std::string page;  ///< folder
  bool by_class = false;
  SearchFlags search;
};

/// The command that shows the failure again.
std::string command_of(const Find& find) {
  const std::string& method = find.failure.who;
  return reproduction(find.path, {{method, find.value.expect.at(method)}});
}

/// The most convincing first: those that break a claim, then false negatives, then by setting, the
/// deepest first.
std::vector<const Find*> new_finds(const HuntReport& report, bool stored) {
  std::vector<const Find*> finds;
  for (const Find& find : report.finds) {
    if (find.is_new && find.path.empty() != stored) finds.push_back(&find);
  }
  // Those alike in the report's order, in which they lie.
  std::ranges::sort(finds, {}, [](const Find* find) {
    const Failure& failure = find->failure;
    return std::tuple(!breaks_claim(failure), failure.outcome == Outcome::kFalsePositive,
                      failure.setting, -find->judged.depth, -find->judged.apart, find);
  });
  return finds;
}

/// Prints one line for the finds of one method that differ in the class of their contact alone. It
/// names the file of the first, and the classes of the others.
void print_finds(const std::vector<const Find*>& finds, const std::string& folder) {
  constexpr size_t kMost = 10;
  const auto alike = [](const Find& find) {
    Failure failure = find.failure;
    failure.contact.clear();
    return failure;
  };
  std::map<Failure, std::vector<std::string>> others;
  std::vector<const Find*> first;
  for (const Find* find : finds) {
    const auto [known, is_first] = others.try_emplace(alike(*find));
    if (is_first) first.push_back(find);
    const std::string& contact = find->failure.contact;
    if (!is_first) known->second.push_back(contact.empty() ? "of no class" : contact);
  }
  std::optional<bool> group;
  for (size_t i = 0; i < std::min(first.size(), kMost); ++i) {
    const Find& find = *first[i];
    const bool breaks = breaks_claim(find.failure);
    if (group != breaks) {
      print_out(fmt::format("New in {}, breaking {} guarantee:\n", folder, breaks ? "a" : "no"));
    }
    group = breaks;
    std::string text = std::filesystem::path(find.path).filename().string();
    text += wrong_by(find.judged);
    const double late_by = find.judged.late_by;
    if (late_by > 0) text += fmt::format(", late by {:.2g}", late_by);
    if (find.cut_short) text += ", not minimised to the end";
    const std::vector<std::string>& classes = others.at(alike(find));
    if (!classes.empty()) {
      text += fmt::format("; {} more: {}", classes.size(), fmt::join(classes, ", "));
    }
    print_out(wrapped("  " + text, 4) + "\n");
    if (const auto test = export_command(find)) print_out("    " + *test + "\n");
  }
  if (first.size() > kMost) print_out(fmt::format("  and {} more\n", first.size() - kMost));
  if (!finds.empty()) print_out("\n");
}

std::uint64_t count_of(const HuntReport& report, bool is_new) {
  return static_cast<std::uint64_t>(std::ranges::count(report.finds, is_new, &Find::is_new));
}

/// Below the table: what its columns count.
std::string hunt_notes(const HuntReport& report) {
  std::string notes;
  if (report.course.back().mutants > 0) {
    notes += "The table counts drawn queries; mutants are only searched for counterexamples.\n";
  }
  if (any_is_traced(report.cells)) {
    notes += "lost: mutants whose known contact the method's tests discard\n";
  }
  return notes;
}

void print_report(const HuntReport& report, const HuntArguments& options) {
  const std::vector<const Find*> stored = new_finds(report, true);
  for (const Find* find : new_finds(report, false)) {
    print_out(fmt::format("Not stored: {}. Its file would be:\n{}\n\n", to_text(find->failure),
                          to_json(find->value)));
  }
  print_finds(stored, options.corpus);
  print_table(hunt_table(report.cells, options.by_class));
  print_out("\n" + mark_note(options.hunt.methods) + column_notes(report.cells) +
            hunt_notes(report));
  if (stored.empty()) return;
  print_out(fmt::format("Show one:     {}\nRun them all: {}\n", command_of(*stored.front()),
                        replay_command(options.corpus, options.hunt.methods)));
}

/// The last line.
void print_summary(const HuntReport& report, const std::string& folder) {
  const std::vector<const Find*> stored = new_finds(report, true);
  const auto breaking = static_cast<std::uint64_t>(
      std::ranges::count_if(stored, [](const Find* find) { return breaks_claim(find->failure); }));
  const std::uint64_t known = count_of(report, false);
  print_out(fmt::format("{} drawn and {} in {:.1f} s\n{} in {}{}{}\n",
                        counted(report.course.back().queries, "query", "queries"),
                        counted(report.course.back().mutants, "mutant", "mutants"), report.seconds,
                        counted(stored.size(), "new counterexample", "new counterexamples"), folder,
                        breaking == 0 ? "" : fmt::format(", {} breaking a guarantee", breaking),
                        known == 0 ? "" : fmt::format("; {} known", known)));
}

void print_report_json(const HuntReport& report) {
  for (const HuntCell& cell : report.cells) print_row(cell);
  for (const Find& find : report.finds) {
    print_row([&](auto& row) {
      const bool is_stored = !find.path.empty();
      row.constant("row", "find");
      row("path", is_stored ? std::optional(find.path) : std::nullopt);
      row("new", find.is_new);
      Failure::fields(row, find.failure);
      row("breaks_claim", breaks_claim(find.failure));
      row.optional("depth", find.judged.depth);
      row.optional("depth_tolerance", find.judged.terms.depth_tolerance);
      row.optional("apart", find.judged.apart);
      row.optional("late_by", find.judged.late_by);
      row.optional("cut_short", find.cut_short);
      row("kind", find.value.origin.kind);
      row("generator", find.value.origin.generator);
      row("expect", find.value.expect);
      if (is_stored) row("reproduce", command_of(find));
      const std::optional<std::string> test = is_stored ? export_command(find) : std::nullopt;
      if (test) row("export", *test);
      if (!is_stored) row("case", find.value);
    });
  }
  print_row([&](auto& row) {
    row.constant("row", "summary");
    row("queries", report.course.back().queries);
    row("cases", report.cases);
    row("finds", count_of(report, true));
    row("known", count_of(report, false));
    row("seconds", report.seconds);
  });
}

void remark_that_nothing_was_asked(const HuntReport& report, const HuntOptions& options,
                                   Session& session) {
  std::string why = "the time was over before";
  std::string more = options.cases ? ": try more --cases" : ": try more --seconds";
  const auto refuses = [](const HuntCell& cell) { return cell.tally.not_asked() > 0; };
  if (std::ranges::any_of(report.cells, refuses)) {
    why = fmt::format("every method refused what it was to be asked about {} cases", report.cases);
    more.clear();
  } else if (report.cases > 0) {
    const std::string rules = options.ground.text();
    why = fmt::format("none of {} cases drawn fits{}", report.cases,
                      rules.empty() ? "" : fmt::format(" ({})", rules));
  }
  session.remark("nothing was checked: no query was asked; {}{}", why, more);
}

bool fails(const HuntReport& report, FailOn fail_on) {
  if (fail_on == FailOn::kAny) return !report.finds.empty();
  return fail_on == FailOn::kClaims &&
         std::ranges::any_of(report.finds, breaks_claim, &Find::failure);
}

/// A method, with a name that is no plug-in's.
Result<std::string> parse_built_in(const std::string& where, const std::string& text) {
  if (names_plugin(text)) return input_error(where, text + " is a plug-in, not built in");
  return parse_method(where, text);
}

Result<Outcome> parse_until(const std::string& where, const std::string& text) {
  const std::optional<Outcome> named = enum_named<Outcome>(text);
  if (named && is_failure(*named)) return *named;
  return input_error(where, "\"{}\" is not one of missed, late, false_positive, error", text);
}

std::vector<std::string> methods_by_default() {
  std::vector<std::string> methods = default_methods();
  methods.insert(methods.begin(), "trad");
  return methods;
}

/// Says whose answers depend on more than the query, in the first find of each that shows it.
void note_differing(const HuntReport& report, Session& session) {
  std::set<std::string> noted;
  for (const Find& find : report.finds) {
    if (!find.differs || !noted.insert(find.failure.who).second) continue;
    const auto note = find.value.origin.more.find(kNote);
    session.remark("{}: {}, found in {}{}", find.failure.who, kAnswersDiffer, find.path,
                   note == find.value.origin.more.end() ? "" : ": " + note->second);
  }
}

int run_hunt(const HuntArguments& arguments, Session& session) {
  HuntArguments options = arguments;
  options.hunt.threads = session.threads;
  options.hunt.search = options.search.options();
  if (options.hunt.ground.bodies && options.hunt.methods == methods_by_default()) {
    options.hunt.methods = {"oracle"};
  }
  options.hunt.ground = need_at("--methods", narrowed(options.hunt.ground, options.hunt.methods));
  const HuntGround& ground = options.hunt.ground;
  if (ground.uniform && !ground.bodies && ground.shapes && !ground.are_linear()) {
    throw BadInput{{"--uniform", "is for bodies or linear patches, and --shape names others"}};
  }
  Store store = need(Store::open(options.corpus));
  // Whether the page can be written is to be known before the work is done.
  if (!options.page.empty()) need(make_writable_folder(options.page));

  const std::atomic<bool>& interrupted = catch_interrupts();
  bool told = false;
  std::set<std::string> failing;
  const HuntReport report = hunt(
      options.hunt, store,
      [&](const HuntProgress& p) {
        for (const Failure& failure : p.met) {
          if (!failing.insert(failure.who).second) continue;
          session.remark("found: {}", to_text(failure));
        }
        if (p.trouble && !std::exchange(told, true)) {
          session.remark(
              "{}: the hunt continues; it keeps its finds in memory and stores them as soon as it "
              "can",
              p.trouble->message());
        }
        session.progress().show(p.share, fmt::format("{} counterexamples", p.finds), p.queries,
                                "queries");
      },
      interrupted);
  session.progress().clear();
  finish_in_order();
  note_differing(report, session);
  session.json ? print_report_json(report) : print_report(report, options);
  if (report.error) throw BadInput{*report.error};
  if (!options.page.empty()) {
    need(write_report(need(hunt_page(report, options.hunt.methods, store)), options.page,
                      options.hunt.threads));
    if (!session.json) print_out(fmt::format("Page:         {}/index.html\n", options.page));
  }
  if (!session.json) print_summary(report, options.corpus);
  if (report.refused) std::rethrow_exception(report.refused);
  if (interrupted) return session.exit_code(kDone);
  // No draw is on the ground, or there was no time for any: then nothing was checked.
  if (report.course.back().queries + report.course.back().mutants == 0) {
    remark_that_nothing_was_asked(report, options.hunt, session);
    return kCheckFailed;
  }
  return fails(report, options.fail_on) ? kCheckFailed : kDone;
}

}  // namespace

void add_hunt(CommandLine& line) {
  auto [command, options] = line.add<HuntArguments>(
      "hunt", "Search for counterexamples and store them (start here)", run_hunt);
  command.example("one minute on your own code, for triangle meshes",
                  "hunt --methods plugin:./libmine.so --linear --ordinary --corpus mine");
  HuntOptions& hunt = options->hunt;
  command.group("How long");
  const Option seconds = command.parsed(
      "--seconds SECONDS", hunt.seconds,
      "How long to search. Then counterexamples are minimised, see --shrink", parse_seconds, "60");
  command
      .whole("--cases", hunt.cases,
             "Instead: this many cases of each contact class, each run with every method. The same "
             "--seed then finds the same",
             1, kMostCases)
      .excludes(seconds);
  command.parsed("--until OUTCOME", hunt.until,
                 "End with the first counterexample of this outcome: missed, late, false_positive, "
                 "error",
                 parse_until);
  command.whole("--seed", hunt.seed, "Seed of the cases");
  command.group("What to test");
  hunt.methods = methods_by_default();
  add_methods(command, hunt.methods, "Methods to test, separated by commas");
  command
      .parsed("--beside METHOD", hunt.beside,
              "A built-in method to time on the same draws; its answers are not judged",
              parse_built_in)
      .in("Methods");
  constexpr int kWidest = 1074;  // 2^-1074 is the least double
  const Option shape = command.parsed("--shape SHAPE", hunt.ground.shapes,
                                      "Only this shape for both patches, or one for each with a "
                                      "comma between, in either order: point, curve:N, triangle:N, "
                                      "tensor:NxM",
                                      parse_shapes);
  Option linear =
      command.flag("--linear", hunt.ground.linear,
                   "Only points, edges and triangles: vertex-face, edge-edge, point-edge, "
                   "point-point; degenerate ones, too");
  linear.excludes(shape);
  command
      .flag("--bodies", hunt.ground.bodies,
            "Only convex bodies: boxes, balls, hulls. They turn for methods that take that. Of the "
            "built-in methods, oracle alone takes bodies, and is then the default")
      .excludes(shape)
      .excludes(linear);
  command.flag("--binary32", hunt.ground.binary32,
               "Only queries whose numbers are all floats, minimised ones too. So is what bodies "
               "move by");
  command.whole(
      "--within", hunt.ground.scale,
      "Only queries whose numbers are 0 or of size 2^-N to 2^N, minimised ones too, so that "
      "neither under- nor overflow explains a failure",
      1, kWidest);
  command.flag(
      "--ordinary", hunt.ground.ordinary,
      "Only queries that any code should answer: patches are apart at 0, and touch well inside of "
      "[0, t_max] or not at all in it; none is degenerate; bodies and linear patches do not "
      "slide, and linear ones that touch pass through each other by a thousandth of their "
      "size; numbers are 0 or of size 2^-40 to 2^40");
  command.flag(
      "--uniform", hunt.ground.uniform,
      "Only bodies or linear patches whose coordinates are drawn uniformly, as a baseline");
  command.group("Results");
  command.text("--corpus FOLDER", options->corpus, "Where to store counterexamples");
  command.choice(
      "--shrink WHICH", hunt.shrink,
      "Minimise the counterexamples of no methods (none), of plug-ins (plugins) or of all. "
      "Takes at most as long as the hunt, or 20 seconds if that is more");
  command.choice(
      "--fail-on WHICH", options->fail_on,
      "Exit with 1 if a method broke its guarantee (claims), after any counterexample (any), "
      "or never (none). Finds met again count, too, though --corpus has them already");
  command.text("--report FOLDER", options->page,
               "Also make a page (index.html) of the counterexamples and of how the hunt went");
  command.flag("--by-class", options->by_class, "A row for each contact class and method");
  command.json("One JSON object per class and method, and per find");
  command.group("Limits");
  options->search.max_pops = kDefaultPops;
  options->search.add_budget_to(command);
  command.max_work("what is in --corpus already");
  command.threads();
}

}  // namespace ccdfuzz
