#include <fmt/format.h>

#include <chrono>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/number_text.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/in_order.hpp"
#include "eval/table.hpp"
#include "properties/registry.hpp"

namespace ccdfuzz {

namespace {

/// Inputs between two looks at the clock and the signals.
constexpr std::uint64_t kBatch = 1024;

struct CheckArguments {
  std::vector<std::string> names;
  std::uint64_t count = 1000;
  std::string seconds;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  int threads = 1;
  bool json = false;
};

/// What the inputs showed of one property.
struct Tallied {
  std::uint64_t checked = 0, discarded = 0, failed = 0;
  std::uint64_t first_failure = 0;  ///< index of the input
  std::string text;                 ///< of the first failure
  double seconds = 0;
};

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Checks inputs first, first + 1, …: `count` of them or, if `seconds` is given, for as long.
Tallied check(const Property& property, const CheckArguments& options,
              std::optional<double> seconds, const std::atomic<bool>& interrupted,
              Progress& progress) {
  Tallied tally;
  const Clock::time_point start = Clock::now();
  const std::uint64_t limit = seconds ? ~std::uint64_t{0} - options.first : options.count;
  while (tally.checked < limit && !interrupted && (!seconds || seconds_since(start) < *seconds)) {
    const std::uint64_t from = options.first + tally.checked;
    run_in_order<Check>(
        std::min(kBatch, limit - tally.checked), options.threads,
        [&](size_t i) {
          RandomChoices choices{Random::keyed({options.seed, from + i})};
          return run(property, choices);
        },
        [&](const Check& result) {
          if (result.status == Check::Status::kDiscarded) ++tally.discarded;
          if (result.status == Check::Status::kFails && tally.failed++ == 0) {
            tally.first_failure = options.first + tally.checked;
            tally.text = result.text;
          }
          ++tally.checked;
        },
        &interrupted);
    tally.seconds = seconds_since(start);
    progress.show(
        seconds ? std::min(1.0, tally.seconds / *seconds)
                : static_cast<double>(tally.checked) / static_cast<double>(limit),
        fmt::format("{}: {} checked, {} failed", property.name, tally.checked, tally.failed));
  }
  return tally;
}

std::string reproduction(const Property& property, const CheckArguments& options,
                         const Tallied& tally) {
  return fmt::format("{} check {} --seed {} --first {} --count 1", program_name(), property.name,
                     options.seed, tally.first_failure);
}

void print_row_json(const Property& property, const CheckArguments& options, const Tallied& tally) {
  nlohmann::ordered_json row = {
      {"property", property.name}, {"expected_to_fail", property.expected == Expectation::kFails},
      {"seed", options.seed},      {"first", options.first},
      {"checked", tally.checked},  {"discarded", tally.discarded},
      {"failed", tally.failed},    {"seconds", tally.seconds}};
  if (tally.failed > 0) {
    row.update({{"failure", tally.text}, {"reproduce", reproduction(property, options, tally)}});
  }
  print_json(row);
}

Result<std::vector<Property>> chosen_properties(const std::vector<std::string>& names) {
  if (names.empty()) return properties();
  std::vector<Property> chosen;
  for (const std::string& name : names) {
    const Result<Property> found = property_named(name);
    if (!found) return tl::unexpected(found.error());
    chosen.push_back(*found);
  }
  return chosen;
}

Result<int> run_check(const CheckArguments& options) {
  const Result<std::vector<Property>> chosen = chosen_properties(options.names);
  if (!chosen) return tl::unexpected(chosen.error());
  std::optional<double> seconds;
  if (!options.seconds.empty()) {
    const Result<double> parsed = parse_seconds("--seconds", options.seconds);
    if (!parsed) return tl::unexpected(parsed.error());
    seconds = *parsed / static_cast<double>(chosen->size());
  }
  if (const auto room = check_room(options.first, options.count, "inputs"); !room) {
    return tl::unexpected(room.error());
  }
  Table table({{"property", Align::kLeft},
               {"checked"},
               {"discarded"},
               {"failed"},
               {"time"},
               {"", Align::kLeft}});
  std::string failures;
  bool broken = false;
  Progress progress;
  const std::atomic<bool>& interrupted = catch_interrupts();
  for (const Property& property : *chosen) {
    if (interrupted) break;
    const Tallied tally = check(property, options, seconds, interrupted, progress);
    progress.clear();
    const bool known_false = property.expected == Expectation::kFails;
    const bool finding = tally.failed > 0 && !known_false;
    broken = broken || finding;
    if (options.json) {
      print_row_json(property, options, tally);
      continue;
    }
    table.add_row({{std::string(property.name)},
                   {fmt::format("{}", tally.checked)},
                   {fmt::format("{}", tally.discarded)},
                   {fmt::format("{}", tally.failed), finding ? Emphasis::kBad : Emphasis::kPlain},
                   {duration_text(tally.seconds)},
                   {known_false ? "known to be false" : ""}});
    if (finding) {
      failures += fmt::format("\n{} fails: {}\nreproduce: {}\n", property.name, tally.text,
                              reproduction(property, options, tally));
    }
  }
  if (!options.json) print_out(table.to_text(wants_colour(stdout)) + failures);
  if (interrupted) return interrupted_exit_code();
  return broken ? kCheckFailed : kDone;
}

struct ListOptions {
  bool json = false;
};

Result<int> run_list(const ListOptions& options) {
  Table table({{"property", Align::kLeft},
               {"claim", Align::kLeft},
               {"source", Align::kLeft},
               {"", Align::kLeft}});
  for (const Property& property : properties()) {
    const bool known_false = property.expected == Expectation::kFails;
    if (options.json) {
      print_json({{"property", property.name},
                  {"claim", property.claim},
                  {"source", property.source},
                  {"expected_to_fail", known_false}});
    } else {
      table.add_row({{std::string(property.name)},
                     {std::string(property.claim)},
                     {std::string(property.source)},
                     {known_false ? "known to be false" : ""}});
    }
  }
  if (!options.json) print_out(table.to_text(wants_colour(stdout)));
  return kDone;
}

}  // namespace

void add_check(CommandLine& line) {
  auto [command, options] = line.add<CheckArguments>(
      "check", "Check properties on random inputs, outside of the tests", run_check);
  command.texts("property", options->names, "Names of properties; by default all");
  const Option count =
      command.whole("--count", options->count, "How many inputs of each property", 1);
  command
      .text("--seconds", options->seconds, "Instead: how long, in equal shares for the properties")
      .excludes(count);
  command.whole("--seed", options->seed, "Seed of the inputs");
  command.whole("--first", options->first, "Index of the first input");
  add_threads(command, options->threads);
  command.flag("--json", options->json, "One JSON object per property");
}

void add_properties(CommandLine& line) {
  auto [command, options] = line.add<ListOptions>(
      "properties", "List the properties, with the claim and source of each", run_list);
  command.flag("--json", options->json, "One JSON object per property");
}

}  // namespace ccdfuzz
