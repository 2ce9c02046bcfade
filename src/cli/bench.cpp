#include <fmt/format.h>

#include <algorithm>

#include "base/table.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/race.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

namespace {

/// All methods but trad end the paper's kind of queries in fewer. trad would take minutes where
/// patches are nearly parallel; its time is then a lower bound.
constexpr std::uint64_t kBenchPops = 2'000;

struct BenchArguments {
  std::string classes = "FF,EF,EE,VF,VE,VV";
  std::string methods = "tdibm-c,trad,tdibm,tdibm-h:1e-12,tdibm-e,tdibm-rational";
  std::string construction = "paper";
  std::uint64_t count = 10;
  std::uint64_t seed = 1;
  bool json = false;
  SearchFlags search;
};

struct Plan {
  std::vector<ContactClass> classes;
  std::vector<std::string> methods;
  Construction construction;
  SearchOptions search;
};

Result<std::vector<ContactClass>> parse_classes(const std::string& list) {
  std::vector<ContactClass> classes;
  for (size_t begin = 0; begin <= list.size();) {
    const size_t end = std::min(list.find(',', begin), list.size());
    const auto one = parse_choice("--classes", list.substr(begin, end - begin), kContactClasses);
    if (!one) return tl::unexpected(one.error());
    if (std::ranges::find(classes, *one) != classes.end()) {
      return input_error("--classes", fmt::format("{} stands there twice", name_of(*one)));
    }
    classes.push_back(*one);
    begin = end + 1;
  }
  return classes;
}

Result<Plan> parse(const BenchArguments& options) {
  Plan plan;
  Result<std::vector<ContactClass>> classes = parse_classes(options.classes);
  if (!classes) return tl::unexpected(classes.error());
  plan.classes = std::move(*classes);
  Result<std::vector<std::string>> methods = parse_method_list(options.methods);
  if (!methods) return tl::unexpected(methods.error());
  plan.methods = std::move(*methods);
  const auto construction = parse_choice("--construction", options.construction, kConstructions);
  if (!construction) return tl::unexpected(construction.error());
  plan.construction = *construction;
  const Result<SearchOptions> search = options.search.parse();
  if (!search) return tl::unexpected(search.error());
  plan.search = *search;
  return plan;
}

/// The queries of one class: `count` positives up to t*, and as many negatives up to t* − 2^-20.
template <class OnQuery>
void for_each_query(const Plan& plan, const BenchArguments& options, ContactClass contact,
                    const OnQuery& on_query) {
  for (std::uint64_t i = 0; i < options.count; ++i) {
    for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
      GeneratorOptions generator;
      generator.contact = contact;
      generator.kind = kind;
      generator.construction = plan.construction;
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
  if (runner.not_asked + base.not_asked > 0) return std::nullopt;
  return seconds_of(runner) / seconds_of(base);
}

double total(const Race::Runner& runner) {
  return runner.seconds;
}
double median(const Race::Runner& runner) {
  return runner.timings.median();
}

/// ≥ where the budget cut some queries short.
std::string ratio_text(const Race::Runner& runner, const std::optional<double>& times) {
  if (!times) return "-";
  const double ratio = *times;
  const char* format = ratio < 10 ? "{}{:.2f}×" : "{}{:.0f}×";
  return fmt::format(fmt::runtime(format), runner.undecided > 0 ? "≥ " : "", ratio);
}

void add_rows(Table& table, ContactClass contact, const Race& race) {
  const Race::Runner& base = race.runners().front();
  table.start_group();
  const auto count_or_nothing = [](std::uint64_t n) { return n > 0 ? fmt::format("{}", n) : ""; };
  for (const Race::Runner& runner : race.runners()) {
    const auto n = static_cast<double>(runner.asked);
    const bool any = runner.asked > 0;
    table.add_row({{std::string(name_of(contact))},
                   {runner.spec},
                   {fmt::format("{}", runner.asked)},
                   {any ? duration_text(runner.seconds / n) : "-"},
                   {any ? duration_text(runner.timings.median()) : "-"},
                   {any ? fmt::format("{:.1f}", static_cast<double>(runner.pops) / n) : "-"},
                   {count_or_nothing(runner.undecided)},
                   {count_or_nothing(runner.not_asked)},
                   {ratio_text(runner, ratio(runner, base, total))},
                   {ratio_text(runner, ratio(runner, base, median))}});
  }
}

void print_rows(const Plan& plan, ContactClass contact, const Race& race) {
  const Race::Runner& base = race.runners().front();
  const auto or_null = [](const std::optional<double>& x) {
    return x ? nlohmann::ordered_json(*x) : nlohmann::ordered_json();
  };
  for (const Race::Runner& runner : race.runners()) {
    print_json({{"class", name_of(contact)},
                {"method", runner.spec},
                {"base", base.spec},
                {"n", runner.asked},
                {"total_seconds", runner.seconds},
                {"median_seconds", runner.timings.median()},
                {"pops", runner.pops},
                {"max_pops", plan.search.max_pops},
                {"undecided", runner.undecided},
                {"not_asked", runner.not_asked},
                {"total_ratio", or_null(ratio(runner, base, total))},
                {"median_ratio", or_null(ratio(runner, base, median))}});
  }
}

Result<int> run_bench(const BenchArguments& options) {
  const Result<Plan> plan = parse(options);
  if (!plan) return tl::unexpected(plan.error());
  const std::string& base = plan->methods.front();
  Table table({{"class", Align::kLeft},
               {"method", Align::kLeft},
               {"n"},
               {"mean"},
               {"median"},
               {"pops"},
               {"undecided"},
               {"not asked"},
               {"total / " + base},
               {"median / " + base}});
  const std::atomic<bool>& interrupted = catch_interrupts();
  Progress progress;
  const double total =
      static_cast<double>(plan->classes.size()) * 2 * static_cast<double>(options.count);
  std::uint64_t done = 0;
  for (const ContactClass contact : plan->classes) {
    Race race(plan->methods, plan->search);
    for_each_query(*plan, options, contact, [&](const Query& query) {
      race.ask(query);
      ++done;
      progress.show(static_cast<double>(done) / total, std::string(name_of(contact)), done,
                    "queries");
      return !interrupted;
    });
    if (options.json) {
      print_rows(*plan, contact, race);
    } else {
      add_rows(table, contact, race);
    }
    if (interrupted) break;
  }
  progress.clear();
  if (!options.json) {
    print_table(table);
    print_out(
        fmt::format("\nCPU time of one thread, the methods by turns on the same queries: positives "
                    "up to t* and negatives up to t* - 2^-20. A query ends after {} pops.\n",
                    plan->search.max_pops));
  }
  return interrupted ? interrupted_exit_code() : kDone;
}

}  // namespace

void add_bench(CommandLine& line) {
  auto [command, options] = line.add<BenchArguments>(
      "bench", "Time methods against each other in one run: ratios, not seconds", run_bench);
  command.whole("--count", options->count, "Cases of each class: a positive and a negative each",
                1);
  command.whole("--seed", options->seed, "Seed of the cases");
  command.text("--classes", options->classes, "Contact classes, separated by commas");
  command.text("--methods", options->methods,
               "Methods, separated by commas; the first is what the others are divided by");
  command.text("--construction", options->construction,
               "paper: as the paper makes them. one-sided: each patch on its own side of a plane");
  options->search.max_pops = kBenchPops;
  options->search.add_to(command);
  command.flag("--json", options->json, "One JSON object for each class and method");
}

}  // namespace ccdfuzz
