#include "hunt/triage.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "base/number_text.hpp"
#include "cli/check_find.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "cli/triage_files.hpp"
#include "files/check_file.hpp"
#include "finds/entries.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "hunt/served_claim.hpp"
#include "io/input_bytes.hpp"
#include "properties/claim_input.hpp"

namespace ccdfuzz {

namespace {

struct TriageArguments {
  FindSuite find_suite;
  std::vector<std::string> inputs;
  std::string output = "finds";
  std::optional<std::string> target;
  std::string known;
  std::string methods = fmt::format("{},trad", fmt::join(default_methods(), ","));
  double seconds = 60;
  SearchFlags search;
  bool json = false;  ///< whether the session prints JSON
  bool remove = false;
};

/// The cases of a file: a case file or a query CSV, or an input of a fuzz target. Errors: it is
/// none.
Result<std::vector<NamedCase>> cases_of_file(const std::string& path) {
  if (case_file_kind(path) || path.ends_with(".csv")) return read_checked_cases(path);
  const Result<std::vector<std::uint8_t>> bytes = read_bytes(path);
  if (!bytes) return tl::unexpected(bytes.error());
  std::vector<NamedCase> cases;
  for (Case& value : cases_of(*bytes)) {
    value.origin.generator = "mutant";
    value.origin.note = "by fuzzing";
    cases.push_back({path, std::move(value)});
  }
  if (cases.empty()) {
    return input_error(path,
                       "is neither a case file nor an input of fuzz_query or fuzz_witnessed (those "
                       "of other targets need --target)");
  }
  return cases;
}

/// A find, as a row of the JSON output.
struct TriagedRow {
  const std::string& input;
  const Failure& failure;
  const std::string& path;

  static void fields(auto& archive, auto& row) {
    archive.constant("row", "find");
    archive("input", row.input);
    Failure::fields(archive, row.failure);
    archive("path", row.path);
  }
};

void triage_cases(const TriageArguments& arguments, const std::function<bool()>& stop,
                  const std::vector<std::string>& files, TriageWalk& walk) {
  TriageOptions options;
  options.methods = need(parse_method_list(arguments.methods));
  Store store = need(Store::open(arguments.output));
  options.search = arguments.search.options();
  options.stop = stop;
  std::string at;  // what is worked on
  options.warn = [&](const std::string& warning) {
    walk.note(fmt::format("ccdfuzz: {}: {}\n", at, warning));
  };
  Triage triage(store, options);
  if (!arguments.known.empty()) {
    for (const NamedCase& entry : need(load_corpus(arguments.known))) triage.know(entry);
  }
  const auto tell = [&](const Failure& failure, const Case&) {
    walk.note_find();
    const std::string path = store.path_of(failure);
    arguments.json ? print_row(TriagedRow{at, failure, path})
                   : print_out(fmt::format("{}: {}\n", to_text(failure), path));
  };
  const auto work = [&](const std::vector<NamedCase>& cases) {
    const std::uint64_t refuting = triage.tally().refuting;
    for (const NamedCase& input : cases) {
      if (stop()) break;
      at = input.id;
      need(triage.add(input.value, tell));
    }
    return !stop() && triage.tally().refuting == refuting;
  };
  walk.go(files, [&](const std::string& file) {
    return cases_of_file(file).map([&](std::vector<NamedCase> cases) -> TriageWalk::Work {
      return [&work, cases = std::move(cases)] { return work(cases); };
    });
  });
  walk.counts().tally = triage.tally();
}

/// Where `ccdfuzz check` has what fails, under the folder of counterexamples.
std::string folder_of_claims(const std::string& folder) {
  return fmt::format("{}/{}", folder, kClaims);
}

/// A find, as a row of the JSON output.
struct ClaimFindRow {
  const std::string& input;
  const ClaimFind& find;
  const std::string& path;

  std::string outcome() const { return find.error.empty() ? "refuted claim" : find.error; }

  static void fields(auto& archive, auto& row) {
    const ClaimFind& find = row.find;
    const bool fails_again = find.shrunk != Shrunk::kNot;
    archive.constant("row", "find");
    archive("input", row.input);
    archive("property", find.property);
    archive("outcome", row.outcome());
    archive("text", fails_again ? find.text : find.found);
    archive("reproduce", find.reproduce());
    archive("fails_again", fails_again);
    archive("cut_short", find.shrunk == Shrunk::kCutShort);
    archive("saved", row.path);
  }
};

/// Confirms the inputs of one target, each in a process apart, and shrinks and stores what is new.
/// That is one counterexample of each claim, and one of each error that putting an input to it ends
/// in. One that could not be shrunk to the end is stored until there is a better. Prints each.
/// Throws BadInput: of the folder or a file.
class ClaimTriage {
 public:
  /// suite: the target's. folder: of finds of claims. known: one more such folder; may be empty, or
  /// not there. stop: true ends shrinking.
  ClaimTriage(Suite suite, std::string folder, std::string known, std::function<bool()> stop,
              bool json, TriageWalk& walk)
      : suite_(std::move(suite)),
        folder_(std::move(folder)),
        known_(std::move(known)),
        stop_(std::move(stop)),
        json_(json),
        walk_(walk) {}

  /// Whether there is nothing left to do with it.
  bool add(const std::string& file, std::span<const std::uint8_t> bytes) {
    TriageTally& tally = walk_.counts().tally;
    ++tally.inputs;
    const auto input = claim_input(suite_, bytes);
    if (!input) {
      ++tally.harmless;
      return true;
    }
    const Property& property = input->property;
    ServedClaim served(property);
    const InputRun run = served.on(input->choices);
    if (!run.fails()) {
      ++tally.harmless;
      return true;
    }
    ++tally.failures;
    ClaimFind find(property, run.error, run.check.text,
                   check_command(property.name, input->choices));
    const std::optional<ClaimFind> known = known_find(find);
    if (known && known->is_complete()) {
      ++tally.known;
      return true;
    }
    if (const auto least = served.least(run, {kShrinkTries, stop_})) {
      find.set_least(*least);
    }
    if (known && !find.replaces(*known)) {
      ++tally.known;
      return !stop_();
    }
    const std::string path = need(save_find(folder_, find));
    walk_.note_find();
    tell({file, find, path});
    return find.is_complete() || !stop_();
  }

 private:
  /// The find in the folder, or a complete one elsewhere. (An incomplete one hides nothing here.)
  std::optional<ClaimFind> known_find(const ClaimFind& find) const {
    const auto in = [&](const std::string& folder) {
      return need(saved_find(folder, find.property, find.error));
    };
    std::optional<ClaimFind> here = in(folder_);
    if ((here && here->is_complete()) || known_.empty()) return here;
    std::optional<ClaimFind> elsewhere = in(known_);
    return elsewhere && elsewhere->is_complete() ? elsewhere : here;
  }

  void tell(const ClaimFindRow& row) const {
    if (json_) return print_row(row);
    const Shrunk shrunk = row.find.shrunk;
    const char* state = shrunk == Shrunk::kToTheEnd   ? ""
                        : shrunk == Shrunk::kCutShort ? ", not shrunk to the end"
                                                      : ", not shrunk";
    print_out(fmt::format("{}: {}{}: {}\n", row.outcome(), row.find.property, state, row.path));
  }

  Suite suite_;
  std::string folder_, known_;
  std::function<bool()> stop_;
  bool json_;
  TriageWalk& walk_;
};

void triage_target(const TriageArguments& arguments, const std::function<bool()>& stop,
                   const std::vector<std::string>& files, TriageWalk& walk) {
  if (*arguments.target == "query" || *arguments.target == "witnessed") {
    throw BadInput{{"--target", "inputs of " + *arguments.target + " are read without it"}};
  }
  const Result<Suite> target = arguments.find_suite(*arguments.target);
  if (!target) throw BadInput{{"--target", target.error().message()}};
  const std::string& known = arguments.known;
  std::error_code error;
  if (!known.empty() && !std::filesystem::is_directory(known, error)) {
    throw BadInput{{"--known", fmt::format("\"{}\" is no folder", known)}};
  }
  const std::string folder = folder_of_claims(arguments.output);
  need(make_find_folder(folder));
  ClaimTriage triage(*target, folder, known.empty() ? "" : folder_of_claims(known), stop,
                     arguments.json, walk);
  walk.go(files, [&](const std::string& file) {
    return read_bytes(file).map([&](std::vector<std::uint8_t> bytes) -> TriageWalk::Work {
      return [&triage, file, bytes = std::move(bytes)] { return triage.add(file, bytes); };
    });
  });
}

int run_triage(const TriageArguments& arguments, Session& session) {
  TriageArguments options = arguments;
  options.json = session.json;
  const std::vector<std::string> files = need(triage_files(options.inputs));
  const std::atomic<bool>& interrupted = catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  const auto is_over = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return interrupted || passed.count() > options.seconds;
  };
  TriageWalk walk(is_over, options.remove);
  (options.target ? triage_target : triage_cases)(options, is_over, files, walk);
  const TriageCounts& counts = walk.counts();
  session.json ? print_row(counts)
               : session.summary(to_text(
                     counts, options.target ? folder_of_claims(options.output) : options.output));
  if (counts.files_unread > 0) return session.exit_code(kBadInput);
  return session.exit_code(counts.tally.refuting > 0 ? kCheckFailed : kDone);
}

}  // namespace

void add_triage(CommandLine& line, const FindSuite& find_suite) {
  auto [command, options] = line.add<TriageArguments>(
      "triage", "Confirm, minimise, deduplicate and store what fuzzers found", run_triage);
  command.example("the findings of a fuzz target", "triage crash-* -o finds");
  options->find_suite = find_suite;
  command
      .texts("input", options->inputs,
             "Inputs of fuzz_query or fuzz_witnessed, case files (.csv among them), or folders of "
             "either")
      .required();
  Option target = command.text("--target NAME", options->target,
                               "The inputs are those of this other target, whose claims fail on "
                               "them; they go to `claims` in the folder");
  command.plugin_names();
  target.excludes(
      command.text("--methods LIST", options->methods, "Methods to run, separated by commas")
          .in("Methods"));
  command.group("Results");
  command.text("-o,--output FOLDER", options->output, "Where to store counterexamples");
  command.text(
      "--known FOLDER", options->known,
      "A corpus, whose failures are not stored again; with --target, those in its `claims`");
  command.flag("--remove", options->remove, "Remove each input file that is done");
  command.json("One JSON object per find, and a summary");
  command.group("Limits");
  command.parsed("--seconds SECONDS", options->seconds, "What is not done by then is left undone",
                 &parse_seconds, "60");
  options->search.max_pops = 10'000;
  for (const Option& budget : options->search.add_budget_to(command)) target.excludes(budget);
  command.max_work();
}

}  // namespace ccdfuzz
