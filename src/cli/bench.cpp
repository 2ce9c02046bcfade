#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "eval/race.hpp"
#include "generators/generate.hpp"
#include "hunt/ground.hpp"
#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

namespace {

/// All methods but trad end the paper's kind of queries in fewer. trad would take minutes where
/// patches are nearly parallel; its time is then a lower bound.
constexpr std::uint64_t kBenchPops = 2'000;

struct BenchOptions {
  std::optional<std::vector<ContactClass>> classes;  ///< absent: all
  bool linear = false;
  std::vector<std::string> methods{"tdibm-c",       "trad",    "tdibm",
                                   "tdibm-h:1e-12", "tdibm-e", "tdibm-rational"};
  GeneratorOptions generator;  ///< but class and kind
  std::uint64_t count = 10;
  SearchFlags search;
};

/// Throws BadInput: a class that has no queries of meshes, if those are asked for.
std::vector<ContactClass> classes_of(const BenchOptions& options) {
  if (!options.linear) {
    return options.classes.value_or(std::vector(kContactClasses.begin(), kContactClasses.end()));
  }
  const std::vector<ContactClass> of_meshes(kLinearClasses.begin(), kLinearClasses.end());
  const std::vector<ContactClass> classes = options.classes.value_or(of_meshes);
  for (const ContactClass contact : classes) {
    if (std::ranges::find(of_meshes, contact) != of_meshes.end()) continue;
    throw BadInput{{"--classes", fmt::format("{} is not asked with --linear: VF, EE, VE, VV are",
                                             name_of(contact))}};
  }
  return classes;
}

/// The queries of one class: `count` positives up to t*, and as many negatives up to t* − 2^-20.
template <class OnQuery>
void for_each_query(const BenchOptions& options, ContactClass contact, const OnQuery& on_query) {
  for (std::uint64_t i = 0; i < options.count; ++i) {
    for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
      GeneratorOptions generator = options.generator;
      generator.contact = contact;
      generator.kind = kind;
      if (options.linear) {
        generator.construction = Construction::kOneSided;
        generator.shapes = shapes_of_class(contact);
      }
      if (!on_query(generate(generator, i).value.query)) return;
    }
  }
}

/// How many times the time of the first method. Nothing where one of the two refused a query or
/// failed on it: those that both answered are then not the same.
std::optional<double> ratio(const Race::Runner& runner, const Race::Runner& base,
                            double (LogHistogram::*time)() const = &LogHistogram::sum) {
  for (const Tally* tally : {&runner.tally, &base.tally}) {
    if (tally->not_asked() + tally->count(Outcome::kError) > 0) return std::nullopt;
  }
  return (runner.tally.seconds.*time)() / (base.tally.seconds.*time)();
}

/// ≥ where the budget cut some queries short.
bool is_bound(const Race::Runner& runner) {
  return runner.tally.count(Outcome::kUndecided) > 0;
}

std::string ratio_text(const Race::Runner& runner, const std::optional<double>& times) {
  if (!times) return "-";
  const double ratio = *times;
  const char* format = ratio < 10 ? "{}{:.2f}×" : "{}{:.0f}×";
  return fmt::format(fmt::runtime(format), is_bound(runner) ? "≥ " : "", ratio);
}

/// The cost of each method on the queries of one class, beside the first.
void print_rows(ContactClass contact, const Race& race, std::uint64_t max_pops) {
  const Race::Runner& base = race.runners().front();
  for (const Race::Runner& runner : race.runners()) {
    const Tally& tally = runner.tally;
    print_row([&](auto& row) {
      row("class", contact);
      row("method", runner.spec);
      row("base", base.spec);
      row("n", tally.n);
      row("total_seconds", tally.seconds.sum());
      row("median_seconds", tally.seconds.median());
      row("pops", tally.pops);
      row("max_pops", max_pops);
      row("undecided", tally.count(Outcome::kUndecided));
      row("not_asked", tally.not_asked());
      row.optional("errors", tally.count(Outcome::kError));
      row("total_ratio", ratio(runner, base));
      row("median_ratio", ratio(runner, base, &LogHistogram::median));
    });
  }
}

using ClassRaces = std::vector<std::pair<ContactClass, Race>>;

/// A row for each method: of the first its mean times, of the others how many times as long all
/// took.
Table ratio_table(const ClassRaces& races) {
  std::vector<Table::Column> columns = {method_column()};
  for (const auto& [contact, race] : races) columns.push_back({std::string(name_of(contact))});
  Table table(std::move(columns));
  for (size_t m = 0; !races.empty() && m < races.front().second.runners().size(); ++m) {
    std::vector<TableCell> row;
    for (const auto& [contact, race] : races) {
      const Race::Runner &base = race.runners().front(), &runner = race.runners()[m];
      if (row.empty()) row.push_back({marked(runner.spec)});
      row.push_back({!runner.fault.empty() ? "error"
                     : runner.tally.n == 0 ? "not asked"
                     : m == 0              ? duration_text(runner.tally.seconds.mean())
                                           : ratio_text(runner, ratio(runner, base))});
    }
    table.add_row(std::move(row));
  }
  return table;
}

void print_races(const ClassRaces& races, const BenchOptions& options) {
  print_table(ratio_table(races));
  const bool has_plugin = std::ranges::any_of(options.methods, names_plugin);
  const auto has = [&](const auto& is_so) {
    return std::ranges::any_of(
        races, [&](const auto& race) { return std::ranges::any_of(race.second.runners(), is_so); });
  };
  const bool has_bounds = has(is_bound);
  const bool has_refusals = has([](const Race::Runner& r) { return r.tally.not_asked() > 0; });
  const std::string bounds =
      fmt::format("≥: some queries ended undecided, after {} pops, and would take longer.\n",
                  *options.search.max_pops);
  print_out(fmt::format(
      "\n{}: mean time of a query. Others: how many times as long all take.\n"
      "{}{}"
      "Queries are up to the contact and, half of them, up to 2^-20 before.\n"
      "Medians, pops and undecided queries: --json\n"
      "{} a class and method; CPU time of one thread, the methods by turns\n{}{}",
      options.methods.front(), mark_note(options.methods), has_bounds ? bounds : "",
      counted(2 * options.count, "query", "queries"),
      has_plugin ? "Of a plug-in: the wall time that it tells, or to it and back\n" : "",
      has_refusals ? "not asked: a method refuses these patches; `evaluate` times bodies\n" : ""));
}

int run_bench(const BenchOptions& options, Session& session) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const std::vector<ContactClass> classes = classes_of(options);
  const double queries =
      static_cast<double>(classes.size()) * 2 * static_cast<double>(options.count);
  std::uint64_t done = 0;
  ClassRaces races;
  for (const ContactClass contact : classes) {
    Race& race =
        races.emplace_back(contact, Race(options.methods, options.search.options())).second;
    for_each_query(options, contact, [&](const Query& query) {
      race.ask(query);
      ++done;
      session.progress().show(static_cast<double>(done) / queries, std::string(name_of(contact)),
                              done, "queries");
      return !interrupted;
    });
    for (const Race::Runner& runner : race.runners()) {
      if (!runner.fault.empty()) session.remark("{}: {}", runner.spec, runner.fault);
    }
    if (session.json) print_rows(contact, race, *options.search.max_pops);
    if (interrupted) break;
  }
  session.progress().clear();
  if (!session.json) print_races(races, options);
  return interrupted ? session.end_early(done, "queries", "the numbers are of these") : kDone;
}

}  // namespace

void add_bench(CommandLine& line) {
  auto [command, options] =
      line.add<BenchOptions>("bench", "Compare the speed of methods in one run", run_bench);
  command.example("your code beside tdibm-c, on mesh queries",
                  "bench --linear --methods tdibm-c,plugin:./libmine.so");
  command.whole("--count", options->count,
                "Cases of each class: one with and one without a contact for each", 1);
  options->generator.seed = 1;
  command.whole("--seed", options->generator.seed, "Seed of the cases");
  command.list("--classes LIST", options->classes,
               "Contact classes, separated by commas; with --linear by default VF,EE,VE,VV",
               &parse_choice<ContactClass>, "FF,EF,EE,VF,VE,VV");
  const Option construction = command.choice(
      "--construction HOW", options->generator.construction,
      "Of quadratic triangles. paper: as the paper makes them. one-sided: each patch on its own "
      "side of a plane");
  command
      .flag("--linear", options->linear,
            "Only points, edges and triangles in place of quadratic triangles: vertex-face, "
            "edge-edge, point-edge, point-point")
      .excludes(construction);
  add_methods(command, options->methods,
              "Methods, separated by commas; the first is what the others are compared with");
  options->search.max_pops = kBenchPops;
  options->search.add_to(command);
  command.json("One JSON object per class and method");
}

}  // namespace ccdfuzz
