#include "hunt/hunt.hpp"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "base/number_text.hpp"
#include "base/text.hpp"
#include "case/case_json.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/course_notes.hpp"
#include "cli/hunt_page.hpp"
#include "cli/hunt_table.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/refusals.hpp"
#include "cli/reproduction.hpp"
#include "cli/shape_text.hpp"
#include "cli/terminal.hpp"
#include "finds/failure.hpp"
#include "hunt/draw.hpp"

namespace ccdfuzz {

namespace {

/// What TDIBM needs stays far below; trad alone reaches it, after about a second.
constexpr std::uint64_t kDefaultPops = 10'000;

/// Of each class: six times as many are still below 2^63.
constexpr std::uint64_t kMostCases = 1'000'000'000'000'000'000;

struct HuntArguments {
  std::string methods = fmt::format("trad,{}", fmt::join(default_methods(), ","));
  std::string seconds = "60";
  std::uint64_t cases = 0;
  int within = 0;  ///< 0: any scale
  std::optional<std::string> shape;
  std::uint64_t seed = 1;
  std::string corpus = "finds";
  std::string fail_on = "none";
  std::string shrink = "plugins";
  bool linear = false;
  std::string page;  ///< folder
  SearchFlags search;
  int threads = 1;
  bool json = false;
};

Result<HuntOptions> parse(const HuntArguments& options) {
  Result<std::vector<std::string>> methods = parse_method_list(options.methods);
  if (!methods) return tl::unexpected(methods.error());
  const SearchOptions search = options.search.options();
  const Result<double> seconds = parse_seconds("--seconds", options.seconds);
  if (!seconds) return tl::unexpected(seconds.error());
  HuntOptions parsed;
  parsed.methods = std::move(*methods);
  parsed.seed = options.seed;
  if (options.within > 0) parsed.ground.scale = options.within;
  parsed.ground.linear = options.linear;
  if (options.shape) {
    const auto shapes = parse_shapes("--shape", *options.shape);
    if (!shapes) return tl::unexpected(shapes.error());
    parsed.ground.shapes = *shapes;
  }
  parsed.threads = options.threads;
  parsed.seconds = *seconds;
  if (options.cases > 0) parsed.cases = options.cases;
  parsed.search = search;
  parsed.shrink = options.shrink == "all"    ? Shrink::kAll
                  : options.shrink == "none" ? Shrink::kNone
                                             : Shrink::kPlugins;
  return parsed;
}

/// "missed by tdibm, tdibm-e (claims none); error (hang) by plugin:./libmine.so".
std::string failures_text(const HuntFind& find) {
  std::map<std::pair<Outcome, std::string>, std::string> by_outcome;
  for (const std::string& method : find.failures) {
    const auto& [outcome, cause] = find.value.expect.at(method);
    std::string& methods = by_outcome[{outcome, cause}];
    if (!methods.empty()) methods += ", ";
    methods += method;
    if (breaks_claim(method, outcome)) methods += " (claims none)";
  }
  std::string text;
  for (const auto& [failure, methods] : by_outcome) {
    const auto& [outcome, cause] = failure;
    if (!text.empty()) text += "; ";
    text += fmt::format("{}{} by {}", name_of(outcome), cause.empty() ? "" : " (" + cause + ")",
                        methods);
  }
  return text;
}

std::uint64_t query_count(const HuntReport& report) {
  std::uint64_t count = 0;
  for (const HuntCell& cell : report.cells) count += cell.tally.n;
  return count;
}

void print_report(const HuntReport& report, const HuntArguments& options) {
  print_table(hunt_table(report.cells));
  print_refusals(report.cells);
  const auto has_early_hits = [](const HuntCell& cell) {
    return cell.tally.count(Outcome::kFalsePositive) > 0;
  };
  if (std::ranges::any_of(report.cells, has_early_hits)) {
    print_out("\nFP: hits of what touches only later or not at all, which every method may give\n");
  }
  print_out(
      fmt::format("\n{} queries about {} cases in {:.1f} s; {:.1f} s of CPU time went into "
                  "making the cases\n",
                  query_count(report), report.cases, report.seconds, report.draw_cpu_seconds));
  const auto print_finds = [&](bool stored) {
    for (const HuntFind& find : report.finds) {
      if (find.path.empty() == stored) continue;
      const Origin& origin = find.value.origin;
      print_out(
          fmt::format("{} {} {}: {}\n    {}\n", origin.contact, origin.kind, origin.generator,
                      failures_text(find),
                      stored ? reproduction(find.path, find.value.expect) : to_json(find.value)));
    }
  };
  const auto unstored = static_cast<size_t>(std::ranges::count(report.finds, "", &HuntFind::path));
  const size_t stored = report.finds.size() - unstored;
  print_out(fmt::format("{} new counterexamples in {}{}\n", stored, options.corpus,
                        stored == 0 ? "" : ", each with the command that shows it:"));
  print_finds(true);
  if (unstored == 0) return;
  print_out(
      fmt::format("{} new counterexamples could not be stored, each with the text of its "
                  ".json file:\n",
                  unstored));
  print_finds(false);
}

void print_report_json(const HuntReport& report) {
  for (const HuntCell& cell : report.cells) print_row(cell);
  for (const HuntFind& find : report.finds) {
    nlohmann::ordered_json expect = nlohmann::ordered_json::object();
    nlohmann::ordered_json errors = nlohmann::ordered_json::object();
    for (const auto& [method, expected] : find.value.expect) {
      expect[method] = name_of(expected.outcome);
      if (expected.outcome == Outcome::kError) errors[method] = expected.cause;
    }
    nlohmann::ordered_json row = {{"row", "find"},
                                  {"path", find.path},
                                  {"class", find.value.origin.contact},
                                  {"kind", find.value.origin.kind},
                                  {"generator", find.value.origin.generator},
                                  {"failures", find.failures},
                                  {"breaks_claim", find.breaks_claim},
                                  {"expect", expect},
                                  {"errors", errors},
                                  {"reproduce", reproduction(find.path, find.value.expect)}};
    if (find.path.empty()) {
      row["path"] = nullptr;
      row.erase("reproduce");
      row["case"] = nlohmann::ordered_json::parse(to_json(find.value));
    }
    print_json(row);
  }
  print_json({{"row", "summary"},
              {"queries", query_count(report)},
              {"cases", report.cases},
              {"finds", report.finds.size()},
              {"seconds", report.seconds}});
}

/// What was asked for, but for what no result depends on.
std::string hunt_command(const HuntArguments& options) {
  const HuntArguments usual;
  std::string text = shell_word(program_name()) + " hunt";
  const auto add = [&](const char* name, const std::string& value) {
    text += fmt::format(" {} {}", name, shell_word(value));
  };
  if (options.cases > 0) {
    add("--cases", fmt::format("{}", options.cases));
  } else {
    add("--seconds", options.seconds);
  }
  if (options.linear) text += " --linear";
  if (options.shape) add("--shape", *options.shape);
  if (options.within > 0) add("--within", fmt::format("{}", options.within));
  add("--seed", fmt::format("{}", options.seed));
  if (options.methods != usual.methods) add("--methods", options.methods);
  if (options.search.max_pops != kDefaultPops) {
    add("--max-pops", fmt::format("{}", options.search.max_pops));
  }
  if (options.search.max_seconds < SearchOptions::kNoTimeLimit) {
    add("--max-seconds", fmt::format("{}", options.search.max_seconds));
  }
  if (options.shrink != usual.shrink) add("--shrink", options.shrink);
  add("--corpus", options.corpus);
  add("--report", options.page);
  return text;
}

Result<void> write_hunt_page(const HuntReport& report, const HuntArguments& options,
                             const HuntCourse& course) {
  HuntRecord record{
      hunt_command(options),        options.corpus, report.seconds, report.cells, {}, course,
      plugins_among(course.methods)};
  for (const HuntFind& find : report.finds) {
    if (!find.path.empty()) record.finds.push_back(find.path);
  }
  if (auto done = write_hunt_record(options.page, record); !done) return done;
  const Result<ReportPage> page = hunt_page(record);
  if (!page) return tl::unexpected(page.error());
  if (auto done = write_report(*page, options.page, options.threads); !done) return done;
  if (!options.json) print_out(fmt::format("{}/index.html shows them\n", options.page));
  return {};
}

/// No draw stands on the ground, or there was no time for any: then nothing was checked.
bool asked_nothing(const HuntReport& report) {
  return query_count(report) == 0 &&
         std::ranges::all_of(report.cells, [](const HuntCell& c) { return c.bred.mutants == 0; });
}

void print_that_nothing_was_asked(const HuntReport& report, const HuntArguments& options) {
  std::string why = "the time was over before";
  const auto refuses = [](const HuntCell& cell) { return cell.tally.not_asked() > 0; };
  if (std::ranges::any_of(report.cells, refuses)) {
    why = fmt::format("every method refused what it was to be asked about {} cases", report.cases);
  } else if (report.cases > 0) {
    why = fmt::format("none of {} cases drawn can be", report.cases);
    if (options.within > 0) why += fmt::format(" with --within {}", options.within);
  }
  print_err(fmt::format("ccdfuzz: nothing was checked: no query was asked; {}: try more {}\n", why,
                        options.cases > 0 ? "--cases" : "--seconds"));
}

bool fails(const HuntReport& report, const std::string& fail_on) {
  if (fail_on == "any") return !report.finds.empty();
  return fail_on == "claims" &&
         std::ranges::any_of(report.finds, [](const HuntFind& f) { return f.breaks_claim; });
}

Result<int> run_hunt(const HuntArguments& options) {
  const Result<HuntOptions> parsed = parse(options);
  if (!parsed) return tl::unexpected(parsed.error());
  Result<Store> store = Store::open(options.corpus);
  if (!store) return tl::unexpected(store.error());

  const std::atomic<bool>& interrupted = catch_interrupts();
  Progress progress;
  CourseNotes notes(parsed->methods, parsed->cases.has_value());
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  bool told = false;
  const HuntReport report = hunt(
      *parsed, *store,
      [&](const HuntProgress& p) {
        notes.note(seconds(), p);
        if (p.trouble && !std::exchange(told, true)) {
          progress.clear();
          print_err(
              fmt::format("ccdfuzz: {}: the hunt continues; it keeps its finds in memory and "
                          "stores them as soon as it can\n",
                          p.trouble->message()));
        }
        progress.show(p.share, fmt::format("{} counterexamples", p.finds), p.queries, "queries");
      },
      interrupted);
  progress.clear();
  finish_in_order();
  options.json ? print_report_json(report) : print_report(report, options);
  if (!options.page.empty()) {
    if (auto done = write_hunt_page(report, options, notes.course()); !done) {
      return tl::unexpected(report.error ? *report.error : done.error());
    }
  }
  if (report.error) return tl::unexpected(*report.error);
  if (interrupted) return interrupted_exit_code();
  if (asked_nothing(report)) {
    print_that_nothing_was_asked(report, options);
    return kCheckFailed;
  }
  return fails(report, options.fail_on) ? kCheckFailed : kDone;
}

}  // namespace

void add_hunt(CommandLine& line) {
  auto [command, options] = line.add<HuntArguments>(
      "hunt", "Find, prove and store inputs on which methods fail (the main job)", run_hunt);
  const Option seconds = command.text("--seconds", options->seconds, "How long to hunt");
  command
      .whole("--cases", options->cases,
             "Instead: this many cases of each class, each put to every method; repeats exactly", 1,
             kMostCases)
      .excludes(seconds)
      .without_default();
  command.text("--methods", options->methods, "Methods to ask, separated by commas");
  constexpr int kWidest = 1074;  // 2^-1074 is the least double
  command
      .whole("--within", options->within,
             "Only queries whose numbers are 0 or between 2^-N and 2^N, so that neither under- nor "
             "overflow explains a failure",
             1, kWidest)
      .without_default();
  command.whole("--seed", options->seed, "Seed of the cases");
  const Option shape = command.text(
      "--shape", options->shape,
      "Only patches of this shape, or of two with a comma between: point, curve:N, triangle:N, "
      "tensor:NxM");
  command
      .flag("--linear", options->linear,
            "Draw linear queries (vertex-face, edge-edge, degenerate ones above all)")
      .excludes(shape);
  command.text("--corpus", options->corpus,
               "Folder to store counterexamples in; `corpus` promotes them to regressions");
  command
      .text("--fail-on", options->fail_on,
            "Exit with 1 after new finds: none, claims (a false negative of a method that claims "
            "to have none) or any")
      .one_of({"none", "claims", "any"});
  command
      .text("--shrink", options->shrink,
            "Whose counterexamples to minimise at the end, for at most as long again or "
            "20 seconds: none, plugins or all")
      .one_of({"none", "plugins", "all"});
  command.text(
      "--report", options->page,
      "Folder for a page (index.html) of the counterexamples and the hunt's course; `report "
      "FOLDER` makes it again");
  options->search.max_pops = kDefaultPops;
  options->search.add_budget_to(command);
  command.threads(options->threads);
  command.flag("--json", options->json, "One JSON object per cell and per find");
  command.max_work();
}

}  // namespace ccdfuzz
