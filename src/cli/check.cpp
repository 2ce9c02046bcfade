#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "cli/check_find.hpp"
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

/// Inputs between two looks at the clock and the signals, at first and at most: some properties
/// take milliseconds an input, others less than one microsecond.
constexpr std::uint64_t kFirstBatch = 4, kLargestBatch = 1024;

/// Runs of a property to shrink a failure of it.
constexpr std::uint64_t kShrinkTries = 4000;

struct CheckArguments {
  std::vector<std::string> names;
  std::uint64_t count = 1000;
  std::string seconds;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  int threads = 1;
  std::string hex;
  std::string save = "finds/properties";
  bool json = false;
};

/// What the inputs showed of one property.
struct Tallied {
  std::uint64_t checked = 0, discarded = 0, failed = 0;
  std::uint64_t first_failure = 0;  ///< index of the input
  std::string text;                 ///< of the first failure
  std::optional<CheckFind> find;    ///< made of the first failure
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
  std::uint64_t batch = kFirstBatch;
  const std::uint64_t limit = seconds ? ~std::uint64_t{0} - options.first : options.count;
  while (tally.checked < limit && !interrupted && (!seconds || seconds_since(start) < *seconds)) {
    const std::uint64_t from = options.first + tally.checked;
    run_in_order<Check>(
        std::min(batch, limit - tally.checked), options.threads,
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
    batch = std::min(2 * batch, kLargestBatch);
    tally.seconds = seconds_since(start);
    progress.show(
        seconds ? std::min(1.0, tally.seconds / *seconds)
                : static_cast<double>(tally.checked) / static_cast<double>(limit),
        fmt::format("{}: {} checked, {} failed", property.name, tally.checked, tally.failed),
        tally.checked, "inputs");
  }
  return tally;
}

std::string reproduction(const Property& property, const CheckArguments& options,
                         const Tallied& tally) {
  return fmt::format("{} check {} --seed {} --first {} --count 1", program_name(), property.name,
                     options.seed, tally.first_failure);
}

/// The first failure shrunk, and saved where it is news.
Result<void> keep_find(const Property& property, const CheckArguments& options, Tallied& tally) {
  const bool known = property.expected == Expectation::kFails;
  // Of a claim that is known to be false, only who asks for it wants to see the simplest failure.
  if (tally.failed == 0 || (known && options.names.empty())) return {};
  RandomChoices choices{Random::keyed({options.seed, tally.first_failure})};
  run(property, choices);
  tally.find = make_find(property, choices.numbers(), kShrinkTries);
  if (known) return {};
  return save_find(options.save, property, *tally.find).map([&](const std::string& path) {
    tally.find->saved = path;
  });
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
  if (tally.find) {
    row.update({{"shrunk", tally.find->least.check.text},
                {"reproduce_shrunk", tally.find->reproduce},
                {"test", tally.find->test}});
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

/// CCDFUZZ_EFFORT, a whole factor on the number of inputs.
Result<std::uint64_t> effort() {
  const char* text = std::getenv("CCDFUZZ_EFFORT");
  if (text == nullptr || *text == '\0') return 1;
  const std::string digits = text;
  constexpr std::size_t kMostDigits = 9;
  if (digits.size() > kMostDigits || digits.find_first_not_of("0123456789") != digits.npos ||
      std::stoull(digits) == 0) {
    return input_error("CCDFUZZ_EFFORT",
                       fmt::format("\"{}\" is not a whole number from 1", digits));
  }
  return std::stoull(digits);
}

/// One input of one property, as a find prints it.
Result<int> check_hex(const CheckArguments& options) {
  if (options.names.size() != 1) return input_error("--hex", "needs the name of one property");
  const Result<Property> property = property_named(options.names[0]);
  if (!property) return tl::unexpected(property.error());
  const auto bytes = parse_hex_bytes(options.hex);
  if (!bytes) return input_error("--hex", bytes.error().message());
  ByteChoices choices(*bytes);
  const Check check = run(*property, choices);
  const bool fails = check.status == Check::Status::kFails;
  const char* status = fails                                       ? "fails"
                       : check.status == Check::Status::kDiscarded ? "is discarded"
                                                                   : "holds";
  if (options.json) {
    print_json({{"property", property->name}, {"status", status}, {"text", check.text}});
  } else {
    print_out(fmt::format("{} {}{}{}\n", property->name, status, check.text.empty() ? "" : ": ",
                          check.text));
  }
  return fails && property->expected == Expectation::kHolds ? kCheckFailed : kDone;
}

Result<int> run_check(const CheckArguments& arguments) {
  CheckArguments options = arguments;
  if (!options.hex.empty()) return check_hex(options);
  const Result<std::uint64_t> factor = effort();
  if (!factor) return tl::unexpected(factor.error());
  if (options.count > ~std::uint64_t{0} / *factor) {
    return input_error("CCDFUZZ_EFFORT", "times --count is too large");
  }
  options.count *= *factor;
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
  const std::atomic<bool>& interrupted = catch_interrupts();
  for (const Property& property : *chosen) {
    if (interrupted) break;
    Progress progress;
    Tallied tally = check(property, options, seconds, interrupted, progress);
    progress.clear();
    if (const auto kept = keep_find(property, options, tally); !kept) {
      return tl::unexpected(kept.error());
    }
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
    if (tally.find) {
      failures += fmt::format("\n{} fails: {}\nreproduce: {}\nas found: {}\n{}{}", property.name,
                              tally.find->least.check.text, tally.find->reproduce,
                              reproduction(property, options, tally),
                              finding ? fmt::format("saved: {}\n", tally.find->saved) : "",
                              tally.find->test);
    }
  }
  if (!options.json) print_out(table.to_text(wants_colour(stdout)) + failures);
  if (interrupted) return interrupted_exit_code();
  return broken ? kCheckFailed : kDone;
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
  command.text("--hex", options->hex, "Instead: one input of one property, as a find prints it");
  command.text("--save", options->save, "Folder for what fails, shrunk");
  add_threads(command, options->threads);
  command.flag("--json", options->json, "One JSON object per property");
}

}  // namespace ccdfuzz
