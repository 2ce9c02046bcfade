#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/number_text.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "cli/check_inputs.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "finds/claim_files.hpp"
#include "generators/draw/choice_bytes.hpp"
#include "hunt/ground.hpp"
#include "io/output_file.hpp"
#include "method/plugin/plugin_spec.hpp"
#include "numeric/effort.hpp"

namespace ccdfuzz {

namespace {

const std::string kFolder = claims_in("finds");

struct CheckArguments {
  std::vector<std::string> names, methods;
  CheckedInputs inputs;
  std::optional<std::string> choices;
  std::string save;
};

/// The result of one property: a row of the table and of the JSON output.
struct CheckedProperty {
  const Property& property;
  const CheckedInputs& inputs;
  CheckTally tally = {};
  std::string reproduce = {};          ///< the first failure
  std::optional<ClaimFind> find = {};  ///< made of it where somebody wants to see it
  bool fails_again = false;            ///< so does its input; of a hang, by its draw
  std::string saved = {};              ///< its path; empty where it need not or could not be saved
  std::string not_saved = {};          ///< why not, as it was found or as it was shrunk

  std::string title() const { return title_of(property.name, property.method); }
  bool known_false() const { return property.expected == Expectation::kFails; }
  bool is_finding() const { return tally.failed > 0 && !known_false(); }
  /// A claim that is known to be false, and these inputs do not show it.
  bool not_refuted() const { return known_false() && tally.failed == 0 && !tally.all_discarded(); }

  static void fields(auto& archive, auto& checked) {
    const CheckTally& tally = checked.tally;
    archive("property", std::string_view(checked.property.name));
    archive.optional("method", checked.property.method);
    archive("expected_to_fail", checked.known_false());
    archive("seed", checked.inputs.seed);
    archive("first", checked.inputs.first);
    archive("checked", tally.checked);
    archive("discarded", tally.discarded);
    archive("failed", tally.failed);
    archive("seconds", tally.seconds);
    archive.optional("nothing_checked", tally.all_discarded());
    archive.when(tally.failed > 0, "failure", tally.text);
    archive.when(tally.failed > 0, "reproduce", checked.reproduce);
    if (checked.find) {
      const ClaimFind& find = *checked.find;
      const bool is_shrunk = find.shrunk != Shrunk::kNot;
      archive("fails_again", checked.fails_again);
      archive.when(is_shrunk, "shrunk", find.text);
      archive.when(is_shrunk, "cut_short", find.shrunk == Shrunk::kCutShort);
      archive.when(is_shrunk, "reproduce_shrunk", reproduction(find));
    }
    archive.optional("saved", checked.saved);
    archive.optional("not_saved", checked.not_saved);
  }
};

/// For the rows of these.
Table check_table(const std::vector<Property>& properties) {
  size_t name = 0;
  for (const Property& property : properties) {
    name = std::max(name, title_of(property.name, property.method).size());
  }
  return Table({{"property", Align::kLeft, name},
                {"inputs", Align::kRight, 7},
                {"failed"},
                {"", Align::kLeft}});
}

std::vector<TableCell> cells_of(const CheckedProperty& checked) {
  const CheckTally& tally = checked.tally;
  // A method that refuses or fails is what a hunt finds.
  const char* const unchecked =
      checked.property.method.empty() ? "nothing checked" : "nothing checked: a hunt tells why";
  const TableCell note = tally.all_discarded()   ? TableCell{unchecked, true}
                         : checked.not_refuted() ? TableCell{"not refuted"}
                         : checked.known_false() ? TableCell{"expected failure"}
                                                 : TableCell{""};
  return {{checked.title()},
          {fmt::format("{}", tally.checked - tally.discarded)},
          {fmt::format("{}", tally.failed), checked.is_finding()},
          note};
}

/// The result of a check, in lines of a terminal's width; --json has the rest.
std::string shown_failure(const std::string& text) {
  std::istringstream lines(wrapped(text, 2));
  std::string shown;
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > kTextWidth) line = line.substr(0, kTextWidth - 3) + "...";
    shown += line + "\n";
  }
  return shown;
}

/// What shrinking made of a find.
std::string shrunk_text(const CheckedProperty& checked) {
  const ClaimFind& find = *checked.find;
  if (find.shrunk == Shrunk::kNot) {
    return checked.fails_again
               ? "not shrunk: its draw hangs each time, which its choices alone do not show\n"
               : "not shrunk: the same input does not fail each time that it is run\n";
  }
  const char* state = find.is_complete() ? "" : " (not to the end)";
  return shown_failure(fmt::format("shrunk{}: {}", state, find.text)) +
         fmt::format("reproduce: {}\n", reproduction(find));
}

/// Prints that, or a find as it was found, and where it is saved.
void print_find(const CheckedProperty& checked, const std::string& text, const char* saved) {
  print_out("\n" + text);
  if (!checked.not_saved.empty()) print_out(fmt::format("not saved: {}\n", checked.not_saved));
  if (!checked.saved.empty()) print_out(fmt::format("{}: {}\n", saved, checked.saved));
  print_out("\n");
}

/// Runs one property on its inputs. A failure is printed and saved at once, and again after it was
/// shrunk, so that an interruption does not lose it. With --json it is printed at the end.
class PropertyCheck {
 public:
  PropertyCheck(const CheckArguments& options, const CheckedInputs& inputs,
                const Property& property, ClaimChildren& children, Session& session)
      : options_(options), children_(children), session_(session), checked_{property, inputs} {}

  const CheckedProperty& checked() const { return checked_; }

  void run(Table& table) {
    checked_.tally = check_inputs(checked_.property, checked_.inputs, children_, catch_interrupts(),
                                  progress_, [this](const CheckTally& tally) { found(tally); });
    progress_.clear();
    if (!session_.json && is_shown()) {
      table.add_row(cells_of(checked_));
      print_rows(table);
    }
    if (checked_.find) {
      need(flush_stdout());
      shrink();
      progress_.clear();
      if (!session_.json) print_find(checked_, shrunk_text(checked_), "saved");
    }
    if (session_.json) print_row(checked_);
    need(flush_stdout());
  }

 private:
  /// A run of all properties shows only what somebody has to look at.
  bool is_shown() const {
    return !options_.names.empty() || checked_.is_finding() || checked_.tally.all_discarded();
  }

  void found(const CheckTally& tally) {
    const Property& property = checked_.property;
    checked_.reproduce = check_command(property.name, property.method,
                                       words_of(checked_.inputs.seed, tally.first_failure));
    // The failure of a claim that is known to be false is for whoever asks for that claim.
    if (checked_.known_false() && options_.names.empty()) return;
    checked_.find = ClaimFind(property, tally.error, tally.text, checked_.reproduce);
    save();
    if (session_.json) return;
    progress_.clear();
    const ClaimFind& find = *checked_.find;
    print_find(checked_,
               shown_failure(fmt::format("{} fails: {}", checked_.title(), find.found)) +
                   fmt::format("as found: {}\n", find.as_found),
               "saved as found");
    need(flush_stdout());
  }

  /// For at most as long as the property was checked, where that is by time.
  void shrink() {
    const CheckedInputs& inputs = checked_.inputs;
    ServedClaims& claims = children_.local();
    const InputRun failed =
        claims.on_draw(checked_.property, inputs.seed, checked_.tally.first_failure);
    if (!failed.fails_as({Check::fails(""), checked_.find->error, {}})) return;
    const Stopwatch watch;
    std::uint64_t runs = 0;
    const auto is_over = [&] {
      progress_.show(static_cast<double>(runs) / static_cast<double>(ShrinkLimits::kTries),
                     fmt::format("{}: shrinking", checked_.property.name), runs, "runs");
      ++runs;
      return session_.interrupted() || (inputs.seconds && watch.seconds() >= *inputs.seconds);
    };
    const auto least = claims.least(checked_.property, failed, {.is_over = is_over});
    checked_.fails_again = least || failed.error == "hang";
    if (!least) return;
    checked_.find->set_least(*least);
    save();
  }

  /// Unless a better find of the same failure is there.
  void save() {
    if (checked_.known_false()) return;
    const Result<SavedClaim> saved =
        save_claim(options_.save.empty() ? kFolder : options_.save, *checked_.find);
    if (saved) checked_.saved = saved->path;
    checked_.not_saved = saved ? "" : saved.error().message();
  }

  const CheckArguments& options_;
  ClaimChildren& children_;
  Session& session_;
  Progress progress_;
  CheckedProperty checked_;
};

/// Each once, in the order in which they are named; with methods, about each of these.
std::vector<Property> chosen_properties(const CheckArguments& options,
                                        const std::vector<Property>& known) {
  std::vector<Property> chosen = options.names.empty() ? known : std::vector<Property>();
  for (const std::string& name : options.names) {
    const Property found = need(property_named(name, known));
    if (std::ranges::count(chosen, found.name, &Property::name) == 0) chosen.push_back(found);
  }
  if (options.methods.empty()) return chosen;
  std::vector<Property> about_those;
  for (const std::string& method : options.methods) {
    need_at("--methods", narrowed({}, {method}));
    for (const Property& claim : chosen) {
      const Result<Property> one = about(claim, method);
      if (one) about_those.push_back(*one);
      if (!one && !options.names.empty()) throw BadInput{{"--methods", one.error().message()}};
    }
  }
  return about_those;
}

/// The find that an input is which somebody else has shrunk, as RapidCheck does.
ClaimFind find_of(const Property& property, const Check& check, const ChoiceNumbers& choices) {
  ClaimFind find(property, "", check.text,
                 check_command(property.name, property.method, words_of(choices)));
  find.set_least({.numbers = choices, .check = check, .is_cut_short = true});
  return find;
}

/// One input of one property, as a find prints it.
int check_choices(const CheckArguments& options, Session& session) {
  if (options.names.size() != 1) throw BadInput{{"--choices", "needs the name of one property"}};
  if (options.methods.size() > 1) throw BadInput{{"--choices", "needs one method at most"}};
  const Property property = chosen_properties(options, session.properties)[0];
  const ChoiceNumbers numbers = need_at("--choices", parse_choices(*options.choices));
  Draw choices = Draw::from_numbers(numbers);
  const Check check = run(property, choices);
  const bool fails = check.status == Check::Status::kFails;
  const bool known_false = property.expected == Expectation::kFails;
  const auto row = [&](auto& archive) {
    archive("property", std::string_view(property.name));
    archive.optional("method", property.method);
    archive("expected_to_fail", known_false);
    archive("status", check.status);
    archive("text", check.text);
  };
  session.say(row, fmt::format("{} {}{}{}{}\n", title_of(property.name, property.method),
                               name_of(check.status), fails && known_false ? " as expected" : "",
                               check.text.empty() ? "" : ": ", check.text));
  if (fails && !options.save.empty()) {
    const SavedClaim saved = need(save_claim(options.save, find_of(property, check, numbers)));
    if (!session.json) print_out(fmt::format("saved: {}\n", saved.path));
  }
  if (check.status == Check::Status::kDiscarded) {
    session.remark("nothing was checked: the input was discarded");
    return kCheckFailed;
  }
  return fails && !known_false ? kCheckFailed : kDone;
}

/// The inputs of each of `properties` properties, with what the environment and the clock say.
CheckedInputs chosen_inputs(CheckedInputs inputs, size_t properties, int threads) {
  inputs.threads = threads;
  const std::uint64_t factor = need(effort());
  if (inputs.count > ~std::uint64_t{0} / factor) {
    throw BadInput{{"CCDFUZZ_EFFORT", fmt::format("{} times --count is too large", factor)}};
  }
  inputs.count *= factor;
  if (inputs.seconds) *inputs.seconds /= static_cast<double>(properties);
  need(check_room(inputs.first, inputs.seconds ? 1 : inputs.count, "inputs"));
  return inputs;
}

int run_check(const CheckArguments& options, Session& session) {
  if (options.choices) return check_choices(options, session);
  const std::vector<Property> chosen = chosen_properties(options, session.properties);
  const CheckedInputs inputs = chosen_inputs(options.inputs, chosen.size(), session.threads);
  if (!options.save.empty()) need(make_writable_folder(options.save));
  Table table = check_table(chosen);
  std::uint64_t done = 0, findings = 0, unchecked = 0, expected = 0, not_refuted = 0, checked = 0;
  const std::atomic<bool>& interrupted = catch_interrupts();
  const bool starts_plugins = std::ranges::any_of(options.methods, names_plugin);
  ClaimChildren children([&] { return ServedClaims(&interrupted, starts_plugins); });
  for (const Property& property : chosen) {
    if (interrupted) break;
    PropertyCheck check(options, inputs, property, children, session);
    check.run(table);
    ++done;
    session.progress().show(static_cast<double>(done) / static_cast<double>(chosen.size()),
                            std::string(property.name), done, "properties");
    checked += check.checked().tally.checked - check.checked().tally.discarded;
    findings += check.checked().is_finding() ? 1 : 0;
    expected += check.checked().known_false() && check.checked().tally.failed > 0 ? 1 : 0;
    unchecked += check.checked().tally.all_discarded() ? 1 : 0;
    not_refuted += check.checked().not_refuted() && !interrupted ? 1 : 0;
  }
  session.progress().clear();
  std::string summary = table.row_count() > 0 ? "\n" : "";
  if (not_refuted > 0) {
    summary += counted(not_refuted, "expected failure", "expected failures") +
               " did not fail: these inputs do not show it\n";
  }
  if (unchecked > 0) {
    summary += counted(unchecked, "property", "properties") +
               " checked nothing: all inputs were discarded\n";
  }
  session.summary(
      summary +
      fmt::format("{}, {} from {} of seed {}: {} failed{}", counted(done, "property", "properties"),
                  counted(checked, "input", "inputs"), inputs.first, inputs.seed, findings,
                  expected > 0 ? fmt::format(", {} failed as expected", expected) : ""));
  if (interrupted) {
    return session.end_early(fmt::format("{} of {} properties begun", done, chosen.size()));
  }
  return findings + unchecked > 0 ? kCheckFailed : kDone;
}

}  // namespace

void add_check(CommandLine& line) {
  auto [command, options] =
      line.add<CheckArguments>("check", "Test properties on random inputs", run_check);
  command.example("all properties for a minute", "check --seconds 60");
  command.texts("property", options->names, "Names of properties; by default all");
  add_methods(
      command, options->methods,
      "Test only the claims metamorphic.*, about these; by default they are about some that "
      "are built in");
  command.group("Inputs");
  const Option count =
      command.whole("--count", options->inputs.count,
                    "How many inputs of each property, times CCDFUZZ_EFFORT of the environment (a "
                    "whole number, by default 1)",
                    1);
  Option seconds =
      command.parsed("--seconds SECONDS", options->inputs.seconds,
                     "Instead, whatever CCDFUZZ_EFFORT is: how long, in equal shares for the "
                     "properties; none is left out, and what fails is shrunk for up to its share "
                     "more",
                     &parse_seconds);
  seconds.excludes(count);
  const Option seed = command.whole("--seed", options->inputs.seed, "Seed of the inputs");
  const Option first = command.whole("--first", options->inputs.first, "Index of the first input");
  Option choices = command.text("--choices LIST", options->choices,
                                "Instead: one input of one property, as a find prints it");
  command.group("Results");
  command.text("--save FOLDER", options->save,
               fmt::format("Folder for what fails that should hold, as found and then shrunk; by "
                           "default {}, and none with --choices",
                           kFolder));
  command.json("One JSON object per property, with all numbers");
  const Option threads = command.threads();
  for (const Option& other : {count, seconds, seed, first, threads}) choices.excludes(other);
}

}  // namespace ccdfuzz
