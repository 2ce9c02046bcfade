#include "generators/generate.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/number_text.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/in_order.hpp"
#include "eval/table.hpp"
#include "query/case_json.hpp"

namespace ccdfuzz {

namespace {

struct GenerateArguments {
  std::string contact, kind;
  std::string construction = "paper";
  std::string family = "regular";
  std::uint64_t seed = 0;
  std::string eps_t;
  std::uint64_t count = 0;
  std::uint64_t first = 0;
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

nlohmann::ordered_json summary_json(const GeneratorOptions& options, const DiscardCounts& counts,
                                    double seconds) {
  nlohmann::ordered_json row = {{"contact", name_of(options.contact)},
                                {"kind", name_of(options.kind)},
                                {"cases", counts.accepted()},
                                {"begun", counts.attempts}};
  for (const Discard reason : kDiscards) {
    row["discarded"][std::string(name_of(reason))] = counts[reason];
  }
  row.update({{"seconds", seconds}, {"cpu_seconds", process_cpu_seconds()}});
  return row;
}

Result<GeneratorOptions> parse(const GenerateArguments& options) {
  const auto contact = parse_choice("--contact", options.contact, kContactClasses);
  if (!contact) return tl::unexpected(contact.error());
  const auto kind = parse_choice("--kind", options.kind, kCaseKinds);
  if (!kind) return tl::unexpected(kind.error());
  const auto construction = parse_choice("--construction", options.construction, kConstructions);
  if (!construction) return tl::unexpected(construction.error());
  const auto family = parse_choice("--family", options.family, kFamilies);
  if (!family) return tl::unexpected(family.error());
  GeneratorOptions generator;
  generator.contact = *contact;
  generator.kind = *kind;
  generator.construction = *construction;
  generator.family = *family;
  generator.seed = options.seed;
  if (!options.eps_t.empty()) {
    const Result<int> exponent = parse_power_of_two("--eps-t", options.eps_t);
    if (!exponent) return tl::unexpected(exponent.error());
    generator.eps_t_exponent = *exponent;
  }
  return validate(generator).map([&] { return generator; });
}

Result<int> run_generate(const GenerateArguments& options) {
  const Result<GeneratorOptions> generator = parse(options);
  if (!generator) return tl::unexpected(generator.error());
  if (const auto room = check_room(options.first, options.count, "cases"); !room) {
    return tl::unexpected(room.error());
  }
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
      options.count, options.threads,
      [&](size_t i) { return generate(*generator, options.first + i); },
      [&](const Generated& generated) {
        if (interrupted) stop = true;
        if (!written || stop) return;
        counts += generated.discards;
        written = destination->write(generated.value);
        if (!written) stop = true;
        progress.show(static_cast<double>(counts.accepted()) / static_cast<double>(options.count),
                      fmt::format("{} cases", counts.accepted()));
      },
      &stop);
  progress.clear();
  if (interrupted) {
    fmt::print(stderr, "ccdfuzz: interrupted after {} cases{}\n", counts.accepted(),
               options.output.empty() ? "" : "; " + options.output + " was not written");
    return interrupted_exit_code();
  }
  if (written) written = destination->finish();
  if (!written) return tl::unexpected(written.error());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (options.json) {
    print_json(summary_json(*generator, counts, elapsed.count()));
  } else {
    fmt::print(stderr, "{}", summary(*generator, counts, elapsed.count()));
  }
  return kDone;
}

}  // namespace

void add_generate(CommandLine& line) {
  auto [command, options] = line.add<GenerateArguments>(
      "generate", "Make cases whose truth is proven, as a data set", run_generate);
  command.text("--contact", options->contact, "Contact class: FF EF EE VF VE VV").required();
  command
      .text("--kind", options->kind,
            "RP: they touch at t_max. RN: t_max is eps-t before that. NHP: as RP, but they graze. "
            "NMN: as NHP, but they just miss")
      .required();
  command.text("--construction", options->construction,
               "paper: as the paper makes them. one-sided: each patch on its own side of a plane");
  std::string families;
  for (const Family f : kFamilies) {
    families += families.empty() ? "" : ", ";
    families += name_of(f);
  }
  command.text("--family", options->family, "What the cases are made to stress: " + families);
  command.whole("--count", options->count, "How many cases", 1).required().without_default();
  command.whole("--first", options->first, "Index of the first one");
  command.whole("--seed", options->seed, "Seed of the data set");
  command.text(
      "--eps-t", options->eps_t,
      "No contact is proven up to this long before t*; a power of two, by default 2^-20, and "
      "2^-10 for NHP");
  const Option output =
      command.text("-o,--output", options->output,
                   "File to write: .jsonl, .jsonl.zst, or .json for one case; default stdout");
  add_threads(command, options->threads);
  command
      .flag("--json", options->json,
            "The summary as a JSON object on stdout; the cases go to a file then")
      .needs(output);
}

}  // namespace ccdfuzz
