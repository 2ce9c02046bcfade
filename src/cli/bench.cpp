#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "eval/race.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

namespace {

/// All methods but trad end the paper's kind of queries in fewer. trad would take minutes where
/// patches are nearly parallel; its time is then a lower bound.
constexpr std::uint64_t kBenchPops = 2'000;

struct BenchOptions {
  std::vector<ContactClass> classes{kContactClasses.begin(), kContactClasses.end()};
  std::vector<std::string> methods{"tdibm-c",       "trad",    "tdibm",
                                   "tdibm-h:1e-12", "tdibm-e", "tdibm-rational"};
  Construction construction = Construction::kPaper;
  std::uint64_t count = 10;
  std::uint64_t seed = 1;
  SearchFlags search;
};

Result<std::vector<ContactClass>> parse_classes(const std::string& where, const std::string& list) {
  std::vector<ContactClass> classes;
  for (const std::string& text : texts_between_commas(list)) {
    const auto one = parse_choice<ContactClass>(where, text);
    if (!one) return tl::unexpected(one.error());
    if (std::ranges::find(classes, *one) != classes.end()) {
      return input_error(where, fmt::format("{} stands there twice", name_of(*one)));
    }
    classes.push_back(*one);
  }
  return classes;
}

/// The queries of one class: `count` positives up to t*, and as many negatives up to t* − 2^-20.
template <class OnQuery>
void for_each_query(const BenchOptions& options, ContactClass contact, const OnQuery& on_query) {
  for (std::uint64_t i = 0; i < options.count; ++i) {
    for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
      GeneratorOptions generator;
      generator.contact = contact;
      generator.kind = kind;
      generator.construction = options.construction;
      generator.seed = options.seed;
      if (!on_query(generate(generator, i).value.query)) return;
    }
  }
}

/// How many times the time of the first method, as seconds_of gives it; nothing where one of the
/// two refused a query: those that both answered are then not the same.
template <class SecondsOf>
std::optional<double> ratio(const Race::Runner& runner, const Race::Runner& base,
                            const SecondsOf& seconds_of) {
  if (runner.tally.not_asked() + base.tally.not_asked() > 0) return std::nullopt;
  return seconds_of(runner.tally.seconds) / seconds_of(base.tally.seconds);
}

constexpr auto kTotal = std::mem_fn(&LogHistogram::sum);
constexpr auto kMedian = std::mem_fn(&LogHistogram::median);

/// ≥ where the budget cut some queries short.
std::string ratio_text(const Race::Runner& runner, const std::optional<double>& times) {
  if (!times) return "-";
  const double ratio = *times;
  const char* format = ratio < 10 ? "{}{:.2f}×" : "{}{:.0f}×";
  return fmt::format(fmt::runtime(format), runner.tally.count(Outcome::kUndecided) > 0 ? "≥ " : "",
                     ratio);
}

/// What one method needed on the queries of one class, beside the first.
struct BenchRow {
  ContactClass contact;
  const Race::Runner& runner;
  const Race::Runner& base;
  std::uint64_t max_pops;

  static void fields(auto& archive, auto& row) {
    const Race::Runner& runner = row.runner;
    const Tally& tally = runner.tally;
    archive("class", row.contact);
    archive("method", runner.spec);
    archive("base", row.base.spec);
    archive("n", tally.n);
    archive("total_seconds", tally.seconds.sum());
    archive("median_seconds", tally.seconds.median());
    archive("pops", tally.pops);
    archive("max_pops", row.max_pops);
    archive("undecided", tally.count(Outcome::kUndecided));
    archive("not_asked", tally.not_asked());
    archive("total_ratio", ratio(runner, row.base, kTotal));
    archive("median_ratio", ratio(runner, row.base, kMedian));
    archive("overrun_seconds", runner.overrun);
  }
};

std::vector<TableCell> bench_cells(const BenchRow& row) {
  const Race::Runner& runner = row.runner;
  const Tally& tally = runner.tally;
  const bool any = tally.n > 0;
  const auto count_or_nothing = [](std::uint64_t count) {
    return count > 0 ? fmt::format("{}", count) : "";
  };
  return {
      {std::string(name_of(row.contact))},
      {runner.spec},
      {fmt::format("{}", tally.n)},
      {any ? duration_text(tally.seconds.mean()) : "-"},
      {any ? duration_text(tally.seconds.median()) : "-"},
      {any ? fmt::format("{:.1f}", static_cast<double>(tally.pops) / static_cast<double>(tally.n))
           : "-"},
      {count_or_nothing(tally.count(Outcome::kUndecided))},
      {count_or_nothing(tally.not_asked())},
      {ratio_text(runner, ratio(runner, row.base, kTotal))},
      {ratio_text(runner, ratio(runner, row.base, kMedian))},
      {runner.overrun ? duration_text(*runner.overrun) : ""}};
}

int run_bench(const BenchOptions& options, Session& session) {
  const std::string& base = options.methods.front();
  session.begin_table({{"class", Align::kLeft},
                       {"method", Align::kLeft},
                       {"n"},
                       {"mean"},
                       {"median"},
                       {"pops"},
                       {"undecided"},
                       {"not asked"},
                       {"total / " + base},
                       {"median / " + base},
                       {"overrun"}});
  const std::atomic<bool>& interrupted = catch_interrupts();
  const double queries =
      static_cast<double>(options.classes.size()) * 2 * static_cast<double>(options.count);
  std::uint64_t done = 0;
  for (const ContactClass contact : options.classes) {
    Race race(options.methods, options.search.options());
    for_each_query(options, contact, [&](const Query& query) {
      race.ask(query);
      ++done;
      session.progress().show(static_cast<double>(done) / queries, std::string(name_of(contact)),
                              done, "queries");
      return !interrupted;
    });
    const Race::Runner& first = race.runners().front();
    for (const Race::Runner& runner : race.runners()) {
      session.show(BenchRow{contact, runner, first, options.search.max_pops}, &runner == &first,
                   bench_cells);
    }
    if (interrupted) break;
  }
  session.end_table();
  session.summary(fmt::format(
      "\nCPU time of one thread, the methods by turns on the same queries: positives up to t* and "
      "negatives up to t* - 2^-20. A query ends after {} pops.",
      options.search.max_pops));
  return session.exit_code(kDone);
}

}  // namespace

void add_bench(CommandLine& line) {
  auto [command, options] = line.add<BenchOptions>(
      "bench", "Time methods against each other in one run: ratios, not seconds", run_bench);
  command.whole("--count", options->count, "Cases of each class: a positive and a negative each",
                1);
  command.whole("--seed", options->seed, "Seed of the cases");
  command.parsed("--classes", options->classes, "Contact classes, separated by commas",
                 &parse_classes, "FF,EF,EE,VF,VE,VV");
  add_methods(command, options->methods,
              "Methods, separated by commas; the first is what the others are divided by");
  command.choice(
      "--construction", options->construction,
      "paper: as the paper makes them. one-sided: each patch on its own side of a plane");
  options->search.max_pops = kBenchPops;
  options->search.add_to(command);
  command.json("One JSON object for each class and method");
}

}  // namespace ccdfuzz
