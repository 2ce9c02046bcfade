#include "generators/generate.hpp"

#include <fmt/format.h>

#include <functional>

#include "base/hex_bytes.hpp"
#include "base/number_text.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/made_cases.hpp"
#include "cli/session.hpp"
#include "generators/paper_set.hpp"
#include "io/cpu_time.hpp"
#include "io/input_bytes.hpp"
#include "io/run_file.hpp"

namespace ccdfuzz {

namespace {

struct GenerateOptions {
  std::optional<ContactClass> contact;
  std::optional<CaseKind> kind;
  /// Absent: paper, or one-sided for shapes that paper has not.
  std::optional<Construction> construction;
  std::optional<std::array<Shape, 2>> shapes;  ///< absent: the family's own
  Family family = Family::kRegular;
  std::uint64_t seed = 0;
  std::optional<int> eps_t_exponent;
  std::uint64_t count = 0;
  std::uint64_t first = 0;
  bool paper = false;
  std::uint64_t one_in = 1;
  std::string shard;
  std::string output;

  bool is_to_stdout() const { return output.empty() || output == "-"; }
};

/// The constructions to make, one by one.
struct Plan {
  RunHeader header;
  std::function<MadeCases(std::uint64_t)> make;
  const char* unit;  ///< what a construction gives
};

GenerationCost cost_of(ContactClass contact, std::string_view kind, std::uint64_t cases,
                       const DiscardCounts& counts, double cpu_seconds) {
  GenerationCost cost{
      std::string(name_of(contact)), std::string(kind), cases, counts.attempts, {}, cpu_seconds};
  for (const Discard reason : kDiscards) {
    cost.discarded.emplace_back(name_of(reason), counts[reason]);
  }
  return cost;
}

Plan paper_plan(const GenerateOptions& options) {
  auto items = std::make_shared<std::vector<PaperItem>>(paper_items(options.one_in));
  RunHeader header{"generate", CCDFUZZ_VERSION, {}, {}, items->size(), {}};
  header.asked = {{"--paper", "yes"},
                  {"--seed", fmt::format("{}", options.seed)},
                  {"--one-in", fmt::format("{}", options.one_in)}};
  return {header,
          [items, seed = options.seed](std::uint64_t i) {
            const PaperItem& item = (*items)[i];
            const double begin = thread_cpu_seconds();
            PaperCases paper = make_paper_cases(item, seed);
            const std::string_view kind = item.kind == CaseKind::kRP ? "RP+RN" : name_of(item.kind);
            GenerationCost cost = cost_of(item.contact, kind, paper.cases.size(), paper.discards,
                                          thread_cpu_seconds() - begin);
            return MadeCases{i, std::move(paper.cases), to_hex_bytes(paper.tree), std::move(cost)};
          },
          "constructions"};
}

GeneratorOptions generator_of(const GenerateOptions& options) {
  GeneratorOptions generator;
  generator.contact = *options.contact;
  generator.kind = *options.kind;
  generator.family = options.family;
  generator.seed = options.seed;
  generator.shapes = options.shapes;
  constexpr std::array kPaperShapes = {Shape::triangle(2), Shape::triangle(2)};
  if (options.shapes && *options.shapes != kPaperShapes) {
    generator.construction = Construction::kOneSided;
  }
  if (options.construction) generator.construction = *options.construction;
  generator.eps_t_exponent = options.eps_t_exponent;
  need(validate(generator));
  return generator;
}

Plan plain_plan(const GenerateOptions& options) {
  for (const auto& [name, given] :
       {std::pair("--contact", options.contact.has_value()),
        std::pair("--kind", options.kind.has_value()), std::pair("--count", options.count > 0)}) {
    if (!given) throw BadInput{{name, "is required without --paper"}};
  }
  const GeneratorOptions g = generator_of(options);
  need(check_room(options.first, options.count, "cases"));
  RunHeader header{"generate", CCDFUZZ_VERSION, {}, {}, options.count, {}};
  const auto shape = [&](size_t side) { return g.shapes ? to_text((*g.shapes)[side]) : "any"; };
  header.asked = {
      {"--contact", std::string(name_of(g.contact))},
      {"--kind", std::string(name_of(g.kind))},
      {"--construction", std::string(name_of(g.construction))},
      {"--shape", shape(0) + "," + shape(1)},
      {"--family", std::string(name_of(g.family))},
      {"--eps-t", g.eps_t_exponent ? fmt::format("2^{}", *g.eps_t_exponent) : "as by default"},
      {"--seed", fmt::format("{}", g.seed)},
      {"--first", fmt::format("{}", options.first)}};
  return {header,
          [g, first = options.first](std::uint64_t i) {
            const double begin = thread_cpu_seconds();
            try {
              Generated made = generate(g, first + i);
              return MadeCases{i,
                               {std::move(made.value)},
                               {},
                               cost_of(g.contact, name_of(g.kind), 1, made.discards,
                                       thread_cpu_seconds() - begin)};
            } catch (const NothingAccepted& none) {
              throw BadInput{{"--eps-t", none.what()}};
            }
          },
          "cases"};
}

/// The same for people who see the cases on stdout, or just a few numbers of one kind.
std::string summary(const GenerationCost& cost) {
  std::string text =
      fmt::format("{} {} {} {}, {} of CPU time each; {} begun", cost.cases, cost.contact, cost.kind,
                  cost.cases == 1 ? "case" : "cases",
                  duration_text(cost.cpu_seconds / static_cast<double>(cost.cases)), cost.begun);
  const char* separator = ", discarded: ";
  for (const auto& [step, count] : cost.discarded) {
    text += fmt::format("{}{} {}", separator, step, count_text(count, cost.begun));
    separator = ", ";
  }
  return text + "\n";
}

void print_costs(const std::vector<GenerationCost>& costs, bool is_paper, bool json) {
  if (json) {
    for (const GenerationCost& cost : costs) print_row(cost);
  } else if (is_paper) {
    print_table(generation_table(costs));
  } else {
    for (const GenerationCost& cost : costs) print_err(summary(cost));
  }
}

/// Where the constructions go: those of a share into its run file, others into a data set; those of
/// the paper's complete set resume from a run file.
struct Target {
  std::optional<ResumedRun> run;
  std::optional<MadeSet> set;
  std::uint64_t before = 0;  ///< constructions of earlier runs
};

Target open_target(const GenerateOptions& options, const RunHeader& header) {
  Target target;
  if (header.shard.is_whole()) target.set = need(MadeSet::open(options.output));
  if (header.shard.is_whole() && !options.paper) return target;
  target.run.emplace(resumed_run(header, options.output, "constructions"));
  auto& [lines, left] = target.run->earlier;
  target.before = left;
  for (; target.set && left > 0; --left) {
    const auto line = need(lines.next());
    need(target.set->add(need(from_json<MadeCases>(line.value_or(""), lines.where()))));
  }
  return target;
}

/// Makes the constructions that are left. Returns how many were made.
std::uint64_t make_all(const Plan& plan, Target& target, Session& session) {
  const Shard& shard = plan.header.shard;
  const std::uint64_t total = shard.size(plan.header.items);
  std::atomic<bool> stop = false;
  Result<void> kept;
  std::uint64_t made_count = 0;
  run_in_order<MadeCases>(
      total - target.before, session.threads,
      [&](size_t i) {
        const std::uint64_t index = shard.item(target.before + i);
        MadeCases made = plan.make(index);
        made.index = index;
        return made;
      },
      [&](MadeCases made) {
        if (session.interrupted() || !kept) stop = true;
        if (!kept || (stop && !target.run)) return;
        const std::string note = made.cost.contact + " " + made.cost.kind;
        if (target.run) kept = target.run->file.append(to_json(made));
        if (kept && target.set) kept = target.set->add(std::move(made));
        const auto done = static_cast<double>(target.before + ++made_count);
        session.progress().show(done / static_cast<double>(total), note, made_count, plan.unit);
      },
      &stop);
  session.progress().clear();
  need(kept);
  return made_count;
}

int run_generate(const GenerateOptions& options, Session& session) {
  if (options.is_to_stdout() || is_stream(options.output)) {
    if (options.paper) {
      throw BadInput{{"--output", "the paper's set goes to a file, which --paper needs"}};
    }
    if (!options.shard.empty())
      throw BadInput{{"--shard", fmt::format("the share {} goes to a file, which --output names",
                                             options.shard)}};
  }
  if (options.is_to_stdout() && session.json) {
    throw BadInput{{"--json", "stdout takes the cases already; name a file with --output"}};
  }
  Plan plan = options.paper ? paper_plan(options) : plain_plan(options);
  plan.header.shard = need(parse_shard(options.shard, plan.header.items, plan.unit));
  const Shard& shard = plan.header.shard;
  if (shard.is_whole() && options.paper &&
      need(case_file_kind(options.output)) == CaseFileKind::kJson) {
    throw BadInput{{options.output, "a .json file holds one case; .jsonl holds many"}};
  }
  catch_interrupts();  // from here on a file may be left
  Target target = open_target(options, plan.header);
  const std::uint64_t made = target.before + make_all(plan, target, session);
  if (session.interrupted()) {
    print_err(fmt::format("ccdfuzz: generate: interrupted after {} {}{}\n", made, plan.unit,
                          target.run               ? "; the same command goes on from there"
                          : options.is_to_stdout() ? ""
                                                   : "; " + options.output + " was not written"));
    return session.exit_code(kDone);
  }
  if (!target.set) {
    need(target.run->file.rename(options.output));
    session.summary(fmt::format("share {}/{} in {}: `merge` puts the shares together", shard.index,
                                shard.of, options.output));
    return kDone;
  }
  need(target.set->finish());
  if (target.run) need(target.run->file.remove());
  print_costs(target.set->costs(), options.paper, session.json);
  if (options.paper) {
    session.summary(fmt::format("\n{} cases in {}, {} miss trees", target.set->cases(),
                                options.output, target.set->trees()));
  }
  return kDone;
}

}  // namespace

void add_generate(CommandLine& line) {
  auto [command, options] = line.add<GenerateOptions>(
      "generate", "Generate a data set whose truth is proven", run_generate);
  command.example("a thousand vertex-vertex contacts",
                  "generate --contact VV --kind RP --count 1000 -o vv.jsonl.zst");
  const Option contact =
      command.choice("--contact CLASS", options->contact, "Contact class: FF EF EE VF VE VV");
  const Option kind =
      command.choice("--kind KIND", options->kind,
                     "RP: they touch at t_max. RN: t_max is eps-t before that. NHP: "
                     "as RP, but they graze. NMN: as NHP, but they just miss");
  Option count = command.whole("--count", options->count, "How many cases", 1);
  count.without_default();
  const Option first = command.whole("--first", options->first, "Index of the first case");
  command.whole("--seed", options->seed, "Seed of the data set");
  const Option construction = command.choice(
      "--construction HOW", options->construction,
      "paper: as the paper makes them, the default where --shape allows it. one-sided: each patch "
      "on its own side of a plane");
  const Option shape = command.parsed(
      "--shape SHAPE", options->shapes,
      "Shape of both patches, or of each with a comma between: point, curve:N, triangle:N, "
      "tensor:NxM. By default triangle:2 in the first six families, random ones in the others",
      &parse_shapes);
  std::string families = "What the cases are made to stress";
  for (const Family f : kAllFamilies) {
    families += fmt::format("\n{}: {}", name_of(f), description_of(f));
  }
  const Option family = command.choice("--family FAMILY", options->family, families);
  const Option eps_t = command.parsed(
      "--eps-t 2^-N", options->eps_t_exponent,
      "No contact is proven up to this long before t*; a power of two, by default 2^-20, and "
      "2^-10 for NHP and families that graze",
      &parse_power_of_two);
  command.group("The paper's data set");
  Option paper = command.flag("--paper", options->paper,
                              "All 24,246 cases of all classes and kinds; killed, the same command "
                              "goes on where it was");
  Option part = command.whole("--one-in", options->one_in, "Only one in N cases of each class", 1);
  part.needs(paper);
  for (const Option& other : {contact, kind, construction, shape, family, count, first, eps_t}) {
    paper.excludes(other);
  }
  command.group("Results");
  add_shard(command, options->shard);
  const Option output = command.text("-o,--output FILE", options->output,
                                     "File to write: .jsonl, .jsonl.zst, or .json for one case; by "
                                     "default stdout. A share is a file for `merge`");
  command.json("The summary as a JSON object on stdout; the cases go to a file then").needs(output);
  command.threads();
}

}  // namespace ccdfuzz
