#include "generators/generate.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>

#include "base/in_order.hpp"
#include "base/number_text.hpp"
#include "base/table.hpp"
#include "case/case_json.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/generate_paper.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/shape_text.hpp"
#include "cli/terminal.hpp"
#include "eval/generation_record.hpp"
#include "generators/paper_set.hpp"

namespace ccdfuzz {

namespace {

struct GenerateArguments {
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
  int threads = 1;
  bool json = false;
};

/// Where the cases go: a file that appears whole or not at all, or stdout.
class Destination {
 public:
  static Result<Destination> open(const std::string& path) {
    Destination destination;
    if (!path.empty() && path != "-") {
      Result<CaseWriter> writer = CaseWriter::open(path);
      if (!writer) return tl::unexpected(writer.error());
      destination.writer_ = std::move(*writer);
    }
    return destination;
  }

  Result<void> write(const Case& value) {
    if (writer_) return writer_->write(value);
    print_out(to_json(value) + "\n");
    return check_stdout();
  }

  Result<void> finish() { return writer_ ? writer_->finish() : flush_stdout(); }

 private:
  std::optional<CaseWriter> writer_;
};

/// CPU time that all threads of this program have used.
double process_cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::string summary(const GeneratorOptions& options, const DiscardCounts& counts, double seconds) {
  const auto made = static_cast<double>(counts.accepted());
  std::string text =
      fmt::format("{} {} {} cases in {}, {} of CPU time each; {} begun", counts.accepted(),
                  name_of(options.contact), name_of(options.kind), duration_text(seconds),
                  duration_text(process_cpu_seconds() / made), counts.attempts);
  const char* separator = ", discarded: ";
  for (const Discard reason : kDiscards) {
    text += fmt::format("{}{} {}", separator, name_of(reason),
                        count_text(counts[reason], counts.attempts));
    separator = ", ";
  }
  return text + "\n";
}

GenerationCost cost_of_run(const GeneratorOptions& options, const DiscardCounts& counts) {
  GenerationCost cost{std::string(name_of(options.contact)),
                      std::string(name_of(options.kind)),
                      counts.accepted(),
                      counts.attempts,
                      {},
                      process_cpu_seconds()};
  for (const Discard reason : kDiscards) {
    cost.discarded.emplace_back(name_of(reason), counts[reason]);
  }
  return cost;
}

nlohmann::ordered_json summary_json(const GenerationCost& cost, double seconds) {
  auto row = nlohmann::ordered_json::parse(to_json(cost));
  row["seconds"] = seconds;
  return row;
}

/// What was asked for but the share, in words.
std::string text_of_run(const GeneratorOptions& g, const GenerateArguments& o) {
  const auto shape = [&](size_t side) { return g.shapes ? to_text((*g.shapes)[side]) : "any"; };
  return fmt::format("{} {}, {}, {},{} {}, eps-t {}, seed {}, {} cases from {}", name_of(g.contact),
                     name_of(g.kind), name_of(g.construction), shape(0), shape(1),
                     name_of(g.family),
                     g.eps_t_exponent ? fmt::format("2^{}", *g.eps_t_exponent) : "as by default",
                     g.seed, o.count, o.first);
}

Result<GeneratorOptions> generator_options(const GenerateArguments& options) {
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
  return validate(generator).map([&] { return generator; });
}

Result<int> run_generate_paper(const GenerateArguments& options) {
  if (options.output.empty() || options.output == "-") {
    return input_error("--output", "the paper's set goes to a file, which --paper needs");
  }
  GeneratePaperOptions paper{options.seed,   options.one_in,  {},
                             options.output, options.threads, options.json};
  const Result<Shard> shard =
      parse_shard(options.shard, paper_items(options.one_in).size(), "constructions");
  if (!shard) return tl::unexpected(shard.error());
  paper.shard = *shard;
  return generate_paper(paper);
}

Result<int> run_generate(const GenerateArguments& options) {
  if (options.paper) return run_generate_paper(options);
  for (const auto& [name, given] :
       {std::pair("--contact", options.contact.has_value()),
        std::pair("--kind", options.kind.has_value()), std::pair("--count", options.count > 0)}) {
    if (!given) return input_error(name, "is required without --paper");
  }
  const Result<GeneratorOptions> generator = generator_options(options);
  if (!generator) return tl::unexpected(generator.error());
  if (const auto room = check_room(options.first, options.count, "cases"); !room) {
    return tl::unexpected(room.error());
  }
  const Result<Shard> shard = parse_shard(options.shard, options.count, "cases");
  if (!shard) return tl::unexpected(shard.error());
  const std::uint64_t count = shard->size(options.count);
  const std::atomic<bool>& interrupted = catch_interrupts();  // from here on a file may be left
  if (options.json && (options.output.empty() || options.output == "-")) {
    return input_error("--json", "stdout takes the cases already; name a file with --output");
  }
  Result<Destination> destination = Destination::open(options.output);
  if (!destination) return tl::unexpected(destination.error());

  std::atomic<bool> stop = false;
  Result<void> written;
  DiscardCounts counts;
  Progress progress;
  const auto start = std::chrono::steady_clock::now();
  run_in_order<Generated>(
      count, options.threads,
      [&](size_t i) { return generate(*generator, options.first + shard->item(i)); },
      [&](const Generated& generated) {
        if (interrupted) stop = true;
        if (!written || stop) return;
        counts += generated.discards;
        written = destination->write(generated.value);
        if (!written) stop = true;
        progress.show(static_cast<double>(counts.accepted()) / static_cast<double>(count),
                      fmt::format("{} cases", counts.accepted()), counts.accepted(), "cases");
      },
      &stop);
  progress.clear();
  if (interrupted) {
    print_err(
        fmt::format("ccdfuzz: interrupted after {} cases{}\n", counts.accepted(),
                    options.output.empty() ? "" : "; " + options.output + " was not written"));
    return interrupted_exit_code();
  }
  const GenerationCost cost = cost_of_run(*generator, counts);
  if (written && !shard->is_whole() && !options.output.empty() && options.output != "-") {
    written = write_generation(generation_path(options.output),
                               {text_of_run(*generator, options), *shard, {cost}});
  }
  if (written) written = destination->finish();
  if (!written) return tl::unexpected(written.error());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (options.json) {
    print_json(summary_json(cost, elapsed.count()));
  } else {
    print_err(summary(*generator, counts, elapsed.count()));
  }
  return kDone;
}

}  // namespace

void add_generate(CommandLine& line) {
  auto [command, options] = line.add<GenerateArguments>(
      "generate", "Make cases whose truth is proven, as a data set", run_generate);
  Option paper =
      command.flag("--paper", options->paper,
                   "The paper's whole set, 24,246 cases of all classes and kinds; killed, "
                   "the same command goes on where it was");
  Option part = command.whole("--one-in", options->one_in,
                              "Of the paper's set only one in so many cases of a class", 1);
  part.needs(paper);
  const Option contact =
      command.choice("--contact", options->contact, "Contact class: FF EF EE VF VE VV");
  const Option kind = command.choice(
      "--kind", options->kind,
      "RP: they touch at t_max. RN: t_max is eps-t before that. NHP: as RP, but they graze. "
      "NMN: as NHP, but they just miss");
  const Option construction = command.choice(
      "--construction", options->construction,
      "paper: as the paper makes them, the default where --shape allows it. one-sided: each "
      "patch on its own side of a plane");
  const Option shape = command.parsed(
      "--shape", options->shapes,
      "Shape of both patches, or of patch 1 and patch 2 with a comma between: point, curve:N, "
      "triangle:N, tensor:NxM. By default triangle:2 in the first six families, random ones in "
      "the others",
      &parse_shapes);
  std::string families = "What the cases are made to stress.";
  for (const Family f : kFamilies) {
    families += fmt::format(" {}: {}.", name_of(f), description_of(f));
  }
  const Option family = command.choice("--family", options->family, families);
  Option count = command.whole("--count", options->count, "How many cases", 1);
  count.without_default();
  const Option first = command.whole("--first", options->first, "Index of the first one");
  command.whole("--seed", options->seed, "Seed of the data set");
  const Option eps_t = command.parsed(
      "--eps-t", options->eps_t_exponent,
      "No contact is proven up to this long before t*; a power of two, by default 2^-20, and "
      "2^-10 for NHP",
      &parse_power_of_two);
  for (const Option& other : {contact, kind, construction, shape, family, count, first, eps_t}) {
    paper.excludes(other);
  }
  add_shard(command, options->shard);
  const Option output =
      command.text("-o,--output", options->output,
                   "File to write: .jsonl, .jsonl.zst, or .json for one case; default stdout");
  command.threads(options->threads);
  command
      .flag("--json", options->json,
            "The summary as a JSON object on stdout; the cases go to a file then")
      .needs(output);
}

}  // namespace ccdfuzz
