#include "generators/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "base/number_text.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/data_set.hpp"
#include "cli/session.hpp"
#include "generators/paper_set.hpp"
#include "io/cpu_time.hpp"
#include "io/input_bytes.hpp"
#include "io/output_file.hpp"
#include "io/run_file.hpp"

namespace ccdfuzz {

namespace {

struct GenerateOptions {
  std::optional<ContactClass> contact;
  std::optional<CaseKind> kind;
  /// Absent: paper, or one-sided for shapes that paper has not.
  std::optional<Construction> construction;
  GeneratorOptions generator;  ///< all but these
  std::optional<std::uint64_t> count;
  std::uint64_t first = 0;
  bool paper = false;
  std::uint64_t one_in = 1;
  std::string shard;
  std::string output;

  bool is_to_stdout() const { return output.empty() || output == "-"; }
  std::string path() const { return is_to_stdout() ? "/dev/stdout" : output; }
};

/// The constructions to make, one by one.
struct Plan {
  std::uint64_t count;
  const char* unit;  ///< what a construction gives
  struct Made {
    ContactClass contact;
    std::string_view kind;
    PaperCases cases;
  };
  std::function<Made(std::uint64_t)> make;
};

MadeCases made_of(const Plan& plan, std::uint64_t index) {
  const double begin = thread_cpu_seconds();
  auto [contact, kind, made] = plan.make(index);
  GenerationCost cost{std::string(name_of(contact)),
                      std::string(kind),
                      made.cases.size(),
                      made.discards.attempts,
                      {},
                      thread_cpu_seconds() - begin};
  for (const Discard reason : kDiscards) {
    cost.discarded.emplace_back(name_of(reason), made.discards[reason]);
  }
  return {index, std::move(made.cases), std::move(cost)};
}

Plan paper_plan(const GenerateOptions& options) {
  auto items = std::make_shared<std::vector<PaperItem>>(paper_items(options.one_in));
  return {items->size(), "constructions", [items, seed = options.generator.seed](std::uint64_t i) {
            const PaperItem& item = (*items)[i];
            return Plan::Made{item.contact,
                              item.kind == CaseKind::kRP ? "RP+RN" : name_of(item.kind),
                              make_paper_cases(item, seed)};
          }};
}

GeneratorOptions generator_of(const GenerateOptions& options) {
  GeneratorOptions generator = options.generator;
  generator.contact = *options.contact;
  generator.kind = *options.kind;
  constexpr std::array kPaperShapes = {Shape::triangle(2), Shape::triangle(2)};
  if (generator.shapes && *generator.shapes != kPaperShapes) {
    generator.construction = Construction::kOneSided;
  }
  if (options.construction) generator.construction = *options.construction;
  // The library names what an option of the same name sets.
  need(validate(generator).map_error([](InputError error) {
    std::ranges::replace(error.where, '_', '-');
    error.where.insert(0, "--");
    return error;
  }));
  return generator;
}

Plan plain_plan(const GenerateOptions& options) {
  for (const auto& [name, given] : {std::pair("--contact", options.contact.has_value()),
                                    std::pair("--kind", options.kind.has_value()),
                                    std::pair("--count", options.count.has_value())}) {
    if (!given) throw BadInput{{name, "is required without --paper"}};
  }
  const GeneratorOptions g = generator_of(options);
  need(check_room(options.first, *options.count, "cases"));
  return {
      *options.count, "cases", [g, first = options.first](std::uint64_t i) {
        try {
          Generated made = generate(g, first + i);
          return Plan::Made{g.contact, name_of(g.kind), {{std::move(made.value)}, made.discards}};
        } catch (const NothingAccepted& none) {
          throw BadInput{{"--eps-t", none.what()}};
        }
      }};
}

/// Where the constructions go: those of a share into its run file, others into a data set; those of
/// the paper's complete set resume from a run file.
struct Target {
  std::optional<RunFile> run;
  std::optional<MadeSet> set;
  std::uint64_t before = 0;  ///< constructions of earlier runs
};

Target open_target(const GenerateOptions& options, const RunHeader& header) {
  Target target;
  if (header.shard.is_whole()) {
    target.set.emplace(options.path());
  }
  if (header.shard.is_whole() && !options.paper) return target;
  target.run.emplace(resumed_run(header, options.output, "constructions"));
  target.before = target.run->size();
  if (!target.set) return target;
  RunLines done = need(target.run->done());
  while (const auto line = need(done.next())) {
    target.set->add(need(from_json<MadeCases>(*line, done.where())));
  }
  return target;
}

/// Makes the constructions that are left. Returns how many were made.
std::uint64_t make_all(const Plan& plan, const Shard& shard, Target& target, Session& session) {
  const std::uint64_t total = shard.size(plan.count);
  std::uint64_t made_count = 0;
  run_in_order<MadeCases>(
      total - target.before, session.threads,
      [&](size_t i) { return made_of(plan, shard.item(target.before + i)); },
      [&](MadeCases made) {
        const std::string note = made.cost.contact + " " + made.cost.kind;
        if (target.run) need(target.run->append(to_json(made)));
        if (target.set) target.set->add(made);
        const auto done = static_cast<double>(target.before + ++made_count);
        session.progress().show(done / static_cast<double>(total), note, made_count, plan.unit);
      },
      &catch_interrupts());
  session.progress().clear();
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
  const Plan plan = options.paper ? paper_plan(options) : plain_plan(options);
  const Shard shard = need(parse_shard(options.shard, plan.count, plan.unit));
  if (shard.is_whole() && options.paper &&
      need(case_file_kind(options.output)) == CaseFileKind::kJson) {
    throw BadInput{{options.output, "a .json file holds one case; .jsonl holds many"}};
  }
  catch_interrupts();  // from here on a file may be left
  Target target =
      open_target(options, {"generate", CCDFUZZ_VERSION, {}, session.asked, plan.count, shard});
  const std::uint64_t made = target.before + make_all(plan, shard, target, session);
  if (session.interrupted()) {
    return target.run ? session.end_early(made, plan.unit, "the same command goes on from there")
                      : session.end_unwritten(made, plan.unit, options.path());
  }
  if (!target.set) {
    need(target.run->rename(options.output));
    session.summary(fmt::format("share {}/{} in {}: `merge` puts the shares together", shard.index,
                                shard.of, options.output));
    return kDone;
  }
  target.set->finish();
  if (target.run) need(target.run->remove());
  // What plain cases cost is a remark.
  if (!options.paper && !session.json) leave_stdout_to("/dev/stdout");
  target.set->show(session);
  return kDone;
}

}  // namespace

void add_generate(CommandLine& line) {
  auto [command, options] = line.add<GenerateOptions>(
      "generate", "Generate a data set of exactly known truth", run_generate);
  command.example("a thousand vertex-vertex contacts",
                  "generate --contact VV --kind RP --count 1000 -o vv.jsonl.zst");
  const Option contact =
      command.choice("--contact CLASS", options->contact, "Contact class: FF EF EE VF VE VV");
  const Option kind = command.choice(
      "--kind KIND", options->kind,
      "RP: they touch at t_max. RN: t_max is eps-t before that. NHP: "
      "as RP, but they graze. NMN: as NHP, but they just miss. NMN, and RN of the paper's "
      "construction and of some trimmed patches, have no certificate: `prove` makes it");
  const Option count = command.whole("--count", options->count, "How many cases", 1);
  const Option first = command.whole("--first", options->first, "Index of the first case");
  command.whole("--seed", options->generator.seed, "Seed of the data set");
  const Option construction = command.choice(
      "--construction HOW", options->construction,
      "paper: as the paper makes them, the default where --shape allows it. one-sided: each patch "
      "on its own side of a plane");
  const Option shape = command.parsed(
      "--shape SHAPE", options->generator.shapes,
      "Shape of both patches, or of each with a comma between: point, curve:N, triangle:N, "
      "tensor:NxM. By default triangle:2 in the first six families, random ones in the others",
      &parse_shapes);
  std::string families = "What the cases are made to stress";
  for (const Family f : kAllFamilies) {
    families += fmt::format("\n{}: {}", name_of(f), description_of(f));
  }
  const Option family = command.choice("--family FAMILY", options->generator.family, families);
  const Option plane = command.flag("--plane", options->generator.plane,
                                    "Bodies that lie, move and turn in the plane z = 0");
  const Option eps_t = command.parsed(
      "--eps-t 2^-N", options->generator.eps_t_exponent,
      "No contact is proven up to this long before t*; a power of two, by default 2^-20, and "
      "2^-10 for NHP and families that graze",
      &parse_power_of_two);
  command.group("The paper's data set");
  Option paper = command.flag("--paper", options->paper,
                              "All 24,246 cases of all classes and kinds; killed, the same command "
                              "goes on where it was");
  Option part = command.whole("--one-in", options->one_in, "Only one in N cases of each class", 1);
  part.needs(paper);
  for (const Option& other :
       {contact, kind, construction, shape, family, plane, count, first, eps_t}) {
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
