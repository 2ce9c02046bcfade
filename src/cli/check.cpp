#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "base/number_text.hpp"
#include "cli/check_row.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "numeric/effort.hpp"
#include "properties/registry.hpp"

namespace ccdfuzz {

namespace {

const std::string kFolder = fmt::format("finds/{}", kPropertyFinds);

struct CheckArguments {
  std::vector<Property> known;
  std::vector<std::string> names;
  CheckedInputs inputs;
  std::optional<std::string> seconds, hex, save;
  bool json = false;
};

/// One property put to its inputs. A failure is told and saved as it was found at once, then as it
/// was shrunk, so that nothing that happens in between loses it; with --json it is told in the end.
class PropertyCheck {
 public:
  PropertyCheck(const CheckArguments& options, const Property& property, ClaimChildren& children,
                const std::atomic<bool>& stop)
      : options_(options), children_(children), stop_(stop), checked_{property,     {}, "",
                                                                      std::nullopt, "", ""} {}

  const CheckedProperty& checked() const { return checked_; }

  /// Errors: of stdout.
  Result<void> run(Table& table) {
    checked_.tally = check_inputs(checked_.property, options_.inputs, children_, stop_, progress_,
                                  [this](const CheckTally& tally) { found(tally); });
    progress_.clear();
    if (!options_.json) print_check_row(table, checked_);
    if (checked_.find) {
      flush();
      shrink();
      progress_.clear();
      if (!options_.json) print_shrunk(checked_);
    }
    if (options_.json) print_check_json(options_.inputs, checked_);
    flush();
    return told_;
  }

 private:
  void found(const CheckTally& tally) {
    checked_.reproduce =
        check_command(checked_.property, options_.inputs.seed, tally.first_failure);
    // Of a claim that is known to be false, only who asks for it wants to see the failure.
    if (checked_.known_false() && options_.names.empty()) return;
    checked_.find = CheckFind{tally.text, checked_.reproduce, tally.error, std::nullopt, "", ""};
    save();
    if (options_.json) return;
    progress_.clear();
    print_found(checked_);
    flush();
  }

  /// For at most as long as the property was checked, where that is by time.
  void shrink() {
    const std::unique_ptr<ServedClaim> claim = children_.take(checked_.property);
    const InputRun found = claim->on_draw(options_.inputs.seed, checked_.tally.first_failure);
    if (!found.fails_as({Check::fails(""), checked_.find->error, {}, {}})) return;
    const auto start = std::chrono::steady_clock::now();
    std::uint64_t runs = 0;
    const auto is_over = [&] {
      progress_.show(static_cast<double>(runs) / static_cast<double>(kShrinkTries),
                     fmt::format("{}: shrinking", checked_.property.name), runs, "runs");
      ++runs;
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
      return stop_ || (options_.inputs.seconds && spent.count() >= *options_.inputs.seconds);
    };
    auto least = claim->least({checked_.property, {}, 0}, found, {kShrinkTries, is_over});
    if (!least) return;
    set_least(*checked_.find, checked_.property, *std::move(least));
    save();
  }

  /// Unless a better find of the same failure stands there.
  void save() {
    if (checked_.known_false()) return;
    const Result<std::string> saved =
        save_find(options_.save.value_or(kFolder), {checked_.property, *checked_.find});
    if (!saved) {
      checked_.not_saved = saved.error().message();
      return;
    }
    checked_.saved = *saved;
    checked_.not_saved.clear();
  }

  void flush() {
    if (told_) told_ = flush_stdout();
  }

  const CheckArguments& options_;
  ClaimChildren& children_;
  const std::atomic<bool>& stop_;
  Progress progress_;
  CheckedProperty checked_;
  Result<void> told_;
};

/// Each once, in the order in which they are named.
Result<std::vector<Property>> chosen_properties(const CheckArguments& options) {
  if (options.names.empty()) return options.known;
  std::vector<Property> chosen;
  for (const std::string& name : options.names) {
    const Result<Property> found = property_named(name, options.known);
    if (!found) return tl::unexpected(found.error());
    const auto is_it = [&](const Property& property) { return property.name == found->name; };
    if (std::ranges::none_of(chosen, is_it)) chosen.push_back(*found);
  }
  return chosen;
}

/// One input of one property, as a find prints it.
Result<int> check_hex(const CheckArguments& options) {
  if (options.names.size() != 1) return input_error("--hex", "needs the name of one property");
  const Result<Property> property = property_named(options.names[0], options.known);
  if (!property) return tl::unexpected(property.error());
  const auto bytes = parse_hex_bytes(*options.hex);
  if (!bytes) return input_error("--hex", bytes.error().message());
  ByteChoices choices(*bytes);
  const Check check = run(*property, choices);
  const bool fails = check.status == Check::Status::kFails;
  const bool expected = property->expected == Expectation::kFails;
  const std::string_view status = name_of(check.status);
  if (options.json) {
    print_json({{"property", property->name},
                {"expected_to_fail", expected},
                {"status", status},
                {"text", check.text}});
  } else {
    print_out(fmt::format("{} {}{}{}{}\n", property->name, status,
                          fails && expected ? ", as is known" : "", check.text.empty() ? "" : ": ",
                          check.text));
  }
  if (check.status == Check::Status::kDiscarded) {
    print_err("ccdfuzz: nothing was checked: the input was discarded\n");
    return kCheckFailed;
  }
  return fails && !expected ? kCheckFailed : kDone;
}

/// The inputs of each of `properties` properties, with what the environment and the clock say.
Result<CheckedInputs> chosen_inputs(const CheckArguments& options, size_t properties) {
  CheckedInputs inputs = options.inputs;
  const Result<std::uint64_t> factor = effort();
  if (!factor) return tl::unexpected(factor.error());
  if (inputs.count > ~std::uint64_t{0} / *factor) {
    return input_error("CCDFUZZ_EFFORT", fmt::format("{} times --count is too large", *factor));
  }
  inputs.count *= *factor;
  if (options.seconds) {
    const Result<double> seconds = parse_seconds("--seconds", *options.seconds);
    if (!seconds) return tl::unexpected(seconds.error());
    inputs.seconds = *seconds / static_cast<double>(properties);
  }
  return check_room(inputs.first, inputs.seconds ? 1 : inputs.count, "inputs").map([&] {
    return inputs;
  });
}

Result<int> run_check(const CheckArguments& arguments) {
  if (arguments.hex) return check_hex(arguments);
  CheckArguments options = arguments;
  const Result<std::vector<Property>> chosen = chosen_properties(options);
  if (!chosen) return tl::unexpected(chosen.error());
  const Result<CheckedInputs> inputs = chosen_inputs(options, chosen->size());
  if (!inputs) return tl::unexpected(inputs.error());
  options.inputs = *inputs;
  if (options.save) {
    if (options.save->empty()) return input_error("--save", "\"\" is not a folder");
    const Result<void> made = make_find_folder(*options.save);
    if (!made) return input_error("--save", made.error().message());
  }
  Table table = check_table(*chosen);
  std::uint64_t done = 0, findings = 0, unchecked = 0, not_refuted = 0;
  const std::atomic<bool>& interrupted = catch_interrupts();
  ClaimChildren children(interrupted);
  for (const Property& property : *chosen) {
    if (interrupted) break;
    PropertyCheck check(options, property, children, interrupted);
    if (const Result<void> told = check.run(table); !told) return tl::unexpected(told.error());
    ++done;
    findings += check.checked().is_finding() ? 1 : 0;
    unchecked += check.checked().tally.all_discarded() ? 1 : 0;
    not_refuted += check.checked().not_refuted() && !interrupted ? 1 : 0;
  }
  if (!options.json) {
    print_next_rows(table);
    std::string summary =
        fmt::format("\n{} {}, inputs from {} of seed {}: {} failed that should hold", done,
                    done == 1 ? "property" : "properties", inputs->first, inputs->seed, findings);
    if (not_refuted > 0) {
      summary += fmt::format(", {} known to be false did not fail", not_refuted);
    }
    if (unchecked > 0) {
      summary += fmt::format(", of {} nothing was checked: all inputs were discarded", unchecked);
    }
    print_out(summary + "\n");
  }
  if (interrupted) {
    print_err(
        fmt::format("ccdfuzz: interrupted: {} of {} properties begun\n", done, chosen->size()));
    return interrupted_exit_code();
  }
  return findings + unchecked > 0 ? kCheckFailed : kDone;
}

}  // namespace

void add_check(CommandLine& line, const std::vector<Property>& known) {
  auto [command, options] = line.add<CheckArguments>(
      "check", "Check properties on random inputs, outside of the tests", run_check);
  options->known = known;
  command.texts("property", options->names, "Names of properties; by default all");
  const Option count =
      command.whole("--count", options->inputs.count,
                    "How many inputs of each property, times CCDFUZZ_EFFORT of the environment (a "
                    "whole number, by default 1)",
                    1);
  Option seconds =
      command.text("--seconds", options->seconds,
                   "Instead, whatever CCDFUZZ_EFFORT is: how long, in equal shares for "
                   "the properties; none is left out, and what fails is shrunk for up to its "
                   "share more");
  seconds.excludes(count);
  const Option seed = command.whole("--seed", options->inputs.seed, "Seed of the inputs");
  const Option first = command.whole("--first", options->inputs.first, "Index of the first input");
  const Option save = command.text(
      "--save", options->save,
      fmt::format("Folder for what fails that should hold, as found and then shrunk; by default {}",
                  kFolder));
  Option hex = command.text("--hex", options->hex,
                            "Instead: one input of one property, as a find prints it");
  const Option threads = command.threads(options->inputs.threads);
  for (const Option& other : {count, seconds, seed, first, save, threads}) hex.excludes(other);
  command.flag("--json", options->json, "One JSON object per property");
}

}  // namespace ccdfuzz
