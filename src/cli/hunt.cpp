#include "hunt/hunt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <utility>

#include "base/number_text.hpp"
#include "case/case_json.hpp"
#include "case/expected_json.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/hunt_page.hpp"
#include "cli/refusals.hpp"
#include "cli/reproduction.hpp"
#include "cli/session.hpp"

namespace ccdfuzz {

namespace {

/// What TDIBM needs stays far below; trad alone reaches it, after about a second.
constexpr std::uint64_t kDefaultPops = 10'000;

/// Of each class: six times as many are still below 2^63.
constexpr std::uint64_t kMostCases = 1'000'000'000'000'000'000;

/// After which finds the command fails.
enum class FailOn : std::uint8_t { kNone, kClaims, kAny };
constexpr std::array kAllFailOn = {FailOn::kNone, FailOn::kClaims, FailOn::kAny};
constexpr const auto& all_of(FailOn) {
  return kAllFailOn;
}
constexpr std::string_view name_of(FailOn fail_on) {
  constexpr std::array<std::string_view, 3> kNames = {"none", "claims", "any"};
  return kNames[static_cast<size_t>(fail_on)];
}

struct HuntArguments {
  HuntOptions hunt;
  std::string corpus = "finds";
  FailOn fail_on = FailOn::kNone;
  int within = 0;  ///< 0: any scale
  std::uint64_t cases = 0;
  std::string page;  ///< folder
  SearchFlags search;
};

/// The command that shows the failure again.
std::string command_of(const Find& find) {
  const std::string& method = find.failure.who;
  return reproduction(find.path, {{method, find.value.expect.at(method)}});
}

/// A find, as a row of the JSON output.
struct HuntFindRow {
  const Find& find;

  static void fields(auto& archive, auto& row) {
    const auto& [failure, path, value, is_new] = row.find;
    const bool is_stored = !path.empty();
    archive.constant("row", "find");
    archive("path", is_stored ? std::optional(path) : std::nullopt);
    archive("new", is_new);
    Failure::fields(archive, failure);
    archive("breaks_claim", breaks_claim(failure));
    archive("kind", value.origin.kind);
    archive("generator", value.origin.generator);
    archive("expect", value.expect);
    if (is_stored) archive("reproduce", command_of(row.find));
    if (!is_stored) archive("case", value);
  }
};

struct SummaryRow {
  std::uint64_t queries, cases, finds, known;
  double seconds;

  static void fields(auto& archive, auto& row) {
    archive.constant("row", "summary");
    archive("queries", row.queries);
    archive("cases", row.cases);
    archive("finds", row.finds);
    archive("known", row.known);
    archive("seconds", row.seconds);
  }
};

std::uint64_t query_count(const HuntReport& report) {
  std::uint64_t count = 0;
  for (const HuntCell& cell : report.cells) count += cell.tally.n;
  return count;
}

std::uint64_t count_of(const HuntReport& report, bool is_new) {
  return static_cast<std::uint64_t>(std::ranges::count(report.finds, is_new, &Find::is_new));
}

void print_finds(const HuntReport& report, bool stored) {
  for (const Find& find : report.finds) {
    const auto& [failure, path, value, is_new] = find;
    if (!is_new || path.empty() == stored) continue;
    print_out(fmt::format("{}{}: {} {}\n    {}\n", to_text(failure),
                          breaks_claim(failure) ? ", which claims none" : "", value.origin.kind,
                          value.origin.generator, stored ? command_of(find) : to_json(value)));
  }
}

void print_report(const HuntReport& report, const std::string& folder) {
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
  const auto unstored = static_cast<size_t>(std::ranges::count(report.finds, "", &Find::path));
  const size_t stored = count_of(report, true) - unstored;
  const std::uint64_t known = count_of(report, false);
  print_out(fmt::format("{} new counterexamples in {}{}{}\n", stored, folder,
                        known == 0 ? "" : fmt::format(" ({} further failures were known)", known),
                        stored == 0 ? "" : ", each with the command that shows it:"));
  print_finds(report, true);
  if (unstored == 0) return;
  print_out(
      fmt::format("{} new counterexamples could not be stored, each with the text of its "
                  ".json file:\n",
                  unstored));
  print_finds(report, false);
}

void print_report_json(const HuntReport& report) {
  for (const HuntCell& cell : report.cells) print_row(cell);
  for (const Find& find : report.finds) print_row(HuntFindRow{find});
  print_row(SummaryRow{query_count(report), report.cases, count_of(report, true),
                       count_of(report, false), report.seconds});
}

void write_hunt_page(const HuntReport& report, const HuntArguments& options,
                     const HuntCourse& course, bool json) {
  HuntRecord record{command_line(),
                    options.corpus,
                    "",
                    report.seconds,
                    report.cells,
                    {},
                    course,
                    plugins_among(course.methods)};
  for (const Find& find : report.finds) {
    if (find.is_new && !find.path.empty()) record.finds.push_back(find.path);
  }
  need(write_hunt_record(options.page, record));
  need(write_report(need(hunt_page(record)), options.page, options.hunt.threads));
  if (!json) print_out(fmt::format("{}/index.html shows them\n", options.page));
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

bool fails(const HuntReport& report, FailOn fail_on) {
  if (fail_on == FailOn::kAny) return !report.finds.empty();
  return fail_on == FailOn::kClaims &&
         std::ranges::any_of(report.finds, breaks_claim, &Find::failure);
}

int run_hunt(const HuntArguments& arguments, Session& session) {
  HuntArguments options = arguments;
  options.hunt.threads = session.threads;
  options.hunt.search = options.search.options();
  if (options.within > 0) options.hunt.ground.scale = options.within;
  if (options.cases > 0) options.hunt.cases = options.cases;
  Store store = need(Store::open(options.corpus));

  const std::atomic<bool>& interrupted = catch_interrupts();
  CourseNotes notes(options.hunt.methods);
  const auto start = std::chrono::steady_clock::now();
  bool told = false;
  const HuntReport report = hunt(
      options.hunt, store,
      [&](const HuntProgress& p) {
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        notes.note(seconds.count(), p);
        if (p.trouble && !std::exchange(told, true)) {
          session.progress().clear();
          print_err(
              fmt::format("ccdfuzz: {}: the hunt continues; it keeps its finds in memory and "
                          "stores them as soon as it can\n",
                          p.trouble->message()));
        }
        session.progress().show(p.share, fmt::format("{} counterexamples", p.finds), p.queries,
                                "queries");
      },
      interrupted);
  session.progress().clear();
  finish_in_order();
  session.json ? print_report_json(report) : print_report(report, options.corpus);
  if (report.error) throw BadInput{*report.error};
  if (!options.page.empty()) write_hunt_page(report, options, notes.course(), session.json);
  if (interrupted) return session.exit_code(kDone);
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
  HuntOptions& hunt = options->hunt;
  const Option seconds =
      command.parsed("--seconds", hunt.seconds, "How long to hunt", parse_seconds, "60");
  command
      .whole("--cases", options->cases,
             "Instead: this many cases of each class, each put to every method; repeats exactly", 1,
             kMostCases)
      .excludes(seconds)
      .without_default();
  hunt.methods = default_methods();
  hunt.methods.insert(hunt.methods.begin(), "trad");
  add_methods(command, hunt.methods, "Methods to ask, separated by commas");
  constexpr int kWidest = 1074;  // 2^-1074 is the least double
  command
      .whole("--within", options->within,
             "Only queries whose numbers are 0 or between 2^-N and 2^N, so that neither under- nor "
             "overflow explains a failure",
             1, kWidest)
      .without_default();
  command.whole("--seed", hunt.seed, "Seed of the cases");
  const Option shape = command.parsed(
      "--shape", hunt.ground.shapes,
      "Only patches of this shape, or of two with a comma between: point, curve:N, triangle:N, "
      "tensor:NxM",
      parse_shapes);
  command
      .flag("--linear", hunt.ground.linear,
            "Draw linear queries (vertex-face, edge-edge, degenerate ones above all)")
      .excludes(shape);
  command.text("--corpus", options->corpus,
               "Folder to store counterexamples in; a file of it that is copied to another corpus "
               "is a regression there");
  command.choice("--fail-on", options->fail_on,
                 "Exit with 1 after finds, known ones too: none, claims (a false negative of a "
                 "method that claims to have none) or any");
  command.choice("--shrink", hunt.shrink,
                 "Whose counterexamples to minimise at the end, for at most as long again or "
                 "20 seconds: none, plugins or all");
  command.text(
      "--report", options->page,
      "Folder for a page (index.html) of the counterexamples and the hunt's course; `report "
      "FOLDER` makes it again");
  options->search.max_pops = kDefaultPops;
  options->search.add_budget_to(command);
  command.threads();
  command.json("One JSON object per cell and per find");
  command.max_work();
}

}  // namespace ccdfuzz
