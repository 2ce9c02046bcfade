#include "hunt/triage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "base/number_text.hpp"
#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "files/check_file.hpp"
#include "finds/claim_files.hpp"
#include "finds/entries.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "hunt/served_claim.hpp"
#include "io/line_reader.hpp"
#include "io/output_file.hpp"
#include "method/plugin/plugin_spec.hpp"
#include "properties/claim_input.hpp"

namespace ccdfuzz {

namespace {

namespace fs = std::filesystem;

struct TriageArguments {
  std::vector<std::string> inputs;
  std::string output = "finds";
  std::optional<std::string> target;
  std::string known;
  std::vector<std::string> methods = default_methods();
  double seconds = 60;
  SearchFlags search;
  bool remove = false;
};

/// The files that the arguments name, in order; folders stand for what is in them, but for what is
/// still being written (OutputFile). Errors: one that is not there or cannot be read.
Result<std::vector<std::string>> triage_files(const std::vector<std::string>& inputs) {
  std::vector<std::string> files;
  for (const std::string& input : inputs) {
    std::error_code error;
    if (!fs::exists(input, error)) return input_error(input, "no such file or folder");
    if (!fs::is_directory(input, error)) {
      files.push_back(input);
      continue;
    }
    CCDFUZZ_TRY(const auto inside, files_under(input, &is_temporary));
    std::ranges::copy_if(inside, std::back_inserter(files), [](const std::string& path) {
      std::error_code gone;  // meanwhile
      return fs::is_regular_file(path, gone);
    });
  }
  return files;
}

/// An input of a fuzz target. Errors: as read_file; it is larger than any.
Result<std::vector<std::uint8_t>> read_bytes(const std::string& path) {
  constexpr std::size_t kMostInputBytes = 1 << 20;  // of libFuzzer by default (-max_len)
  return read_file(path, kMostInputBytes).map([](const std::string& bytes) {
    return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
  });
}

/// The cases of an input of a fuzz target. Errors: it is none.
Result<std::vector<Case>> fuzzed_cases(const std::string& path) {
  CCDFUZZ_TRY(const std::vector<std::uint8_t> bytes, read_bytes(path));
  std::vector<Case> cases = cases_of(bytes);
  for (Case& value : cases) {
    value.origin.generator = "mutant";
    value.origin.note = "by fuzzing";
  }
  if (cases.empty()) {
    return input_error(path,
                       "is neither a case file nor an input of fuzz_query or fuzz_witnessed (those "
                       "of other targets need --target)");
  }
  return cases;
}

/// The results for the files that fuzzers left, and for the inputs in them.
struct TriageCounts {
  std::uint64_t files = 0, files_done = 0, files_unread = 0, files_gone = 0;
  TriageTally tally;
  std::uint64_t finds = 0;

  static void fields(auto& archive, auto& counts) {
    archive.constant("row", "summary");
    archive("files", counts.files);
    archive("files_done", counts.files_done);
    archive("files_unread", counts.files_unread);
    archive.optional("files_gone", counts.files_gone);
    TriageTally::fields(archive, counts.tally);
    archive("finds", counts.finds);
  }
};

/// "3 of 3 files: …". folder: where finds are. own_code_may_fail: on some inputs no method failed,
/// and no plug-in was asked.
std::string to_text(const TriageCounts& counts, const std::string& folder, bool own_code_may_fail) {
  const TriageTally& tally = counts.tally;
  std::string text = fmt::format(
      "{} of {} files{}: {} failures, {} of them like one that is stored; {} inputs on which "
      "nothing fails; {} new in {}",
      counts.files_done, counts.files,
      counts.files_gone > 0 ? fmt::format(" ({} gone meanwhile)", counts.files_gone) : "",
      tally.failures, tally.known, tally.harmless, counts.finds, folder);
  if (own_code_may_fail) {
    text += "\nIf your own code failed on them, ask it as a plug-in: --methods plugin:PATH";
  }
  if (tally.refuting == 0) return text;
  return fmt::format("{}\n{} refute a claim by no full run (see above), and stay", text,
                     tally.refuting);
}

class TriageRun {
 public:
  TriageRun(const TriageArguments& arguments, Session& session)
      : arguments_(arguments), session_(session) {}

  int run() {
    const std::vector<std::string> files = need(triage_files(arguments_.inputs));
    const std::string& known = arguments_.known;
    if (std::error_code error; !known.empty() && !fs::is_directory(known, error)) {
      throw BadInput{{"--known", fmt::format("\"{}\" is no folder", known)}};
    }
    counts_.files = files.size();
    arguments_.target ? triage_claims(files) : triage_cases(files);
    session_.progress().clear();
    session_.note_rounded();
    if (session_.json) print_row(counts_);
    const bool asked_plugins = std::ranges::any_of(arguments_.methods, names_plugin);
    session_.summary(to_text(counts_,
                             arguments_.target ? claims_in(arguments_.output) : arguments_.output,
                             !arguments_.target && !asked_plugins && counts_.tally.harmless > 0));
    if (counts_.files_unread > 0) return session_.exit_code(kBadInput);
    return session_.exit_code(counts_.tally.refuting > 0 ? kCheckFailed : kDone);
  }

 private:
  bool is_over() const { return session_.interrupted() || watch_.seconds() > arguments_.seconds; }

  /// work(file) returns a Result<bool>, which is false if the file is not done, or is to stay. Its
  /// error says where the file is no input: what is before that is triaged, and the file stays. A
  /// file that is no more is passed over: somebody else may work on the same folder. Throws
  /// BadInput: of the work; a file that cannot be removed.
  template <class Work>
  void go(const std::vector<std::string>& files, const Work& work) {
    for (const std::string& file : files) {
      if (is_over()) return;
      const Result<bool> done = work(file);
      std::error_code error;
      if (!done && !fs::exists(file, error)) {
        ++counts_.files_gone;
        continue;
      }
      if (!done) {
        session_.remark("{}; it is left as it is", done.error().message());
        ++counts_.files_unread;
        continue;
      }
      // Work that was done in spite of that counts.
      if (!*done && is_over()) return;
      ++counts_.files_done;
      if (*done && arguments_.remove) fs::remove(file, error);
      if (error) throw BadInput{{file, "cannot be removed: " + error.message()}};
      session_.progress().show(
          static_cast<double>(counts_.files_done) / static_cast<double>(counts_.files),
          fmt::format("{} new", counts_.finds), counts_.files_done, "inputs");
    }
  }

  void triage_cases(const std::vector<std::string>& files) {
    TriageOptions options;
    options.methods = arguments_.methods;
    Store store = need(Store::open(arguments_.output));
    options.search = arguments_.search.options();
    options.stop = [this] { return is_over(); };
    std::string at;  // what is worked on
    options.warn = [&](const std::string& what) { session_.remark("{}: {}", at, what); };
    if (!arguments_.known.empty()) {
      need(for_each_entry(arguments_.known, [&](const NamedCase& entry) { store.know(entry); }));
    }
    Triage triage(store, options);
    const auto tell = [&](const Failure& failure, const Case&) {
      ++counts_.finds;
      const std::string path = store.path_of(failure);
      const auto row = [&](auto& archive) {
        archive.constant("row", "find");
        archive("input", at);
        Failure::fields(archive, failure);
        archive("path", path);
      };
      session_.say(row, fmt::format("{}: {}\n", to_text(failure), path));
    };
    const auto add = [&](const std::string& id, const Case& input) {
      at = id;
      if (!is_over()) need(triage.add(input, tell));
    };
    go(files, [&](const std::string& file) -> Result<bool> {
      const std::uint64_t refuting = triage.tally().refuting;
      if (case_file_kind(file) || file.ends_with(".csv")) {
        for (CaseStream cases({file}); !is_over();) {
          CCDFUZZ_TRY(const auto input, session_.next_case(cases));
          if (!input) break;
          add(input->id, input->value);
        }
      } else {
        CCDFUZZ_TRY(const std::vector<Case> inputs, fuzzed_cases(file));
        for (const Case& input : inputs) add(file, input);
      }
      return !is_over() && triage.tally().refuting == refuting;
    });
    counts_.tally = triage.tally();
  }

  /// Confirms the inputs of one target in a process apart, and shrinks and stores what is
  /// new. That is one counterexample of each claim, and one of each error that putting an input to
  /// it ends in. One that could not be shrunk to the end is stored until there is a better.
  void triage_claims(const std::vector<std::string>& files) {
    std::string_view name = *arguments_.target;
    constexpr std::string_view kProgram = "fuzz_";  // which the target's program begins with
    if (name.starts_with(kProgram)) name.remove_prefix(kProgram.size());
    if (name == "query" || name == "witnessed") {
      throw BadInput{{"--target", fmt::format("inputs of {} are read without it", name)}};
    }
    const Suite suite = need_at("--target", session_.find_suite(name));
    need(make_writable_folder(claims_in(arguments_.output)));
    ServedClaims served;
    go(files, [&](const std::string& file) -> Result<bool> {
      CCDFUZZ_TRY(const std::vector<std::uint8_t> bytes, read_bytes(file));
      const auto input = claim_input(suite, bytes);
      if (!input) return input_error(file, "is no input of fuzz_{}: it names no claim", name);
      ++counts_.tally.inputs;
      return triage_claim(file, *input, served);
    });
    TriageTally& tally = counts_.tally;
    tally.harmless = tally.inputs - tally.failures;
  }

  /// Whether there is nothing left to do with it.
  bool triage_claim(const std::string& file, const ClaimInput& input, ServedClaims& served) {
    TriageTally& tally = counts_.tally;
    const Property& property = input.property;
    const InputRun run = served.on(property, input.choices);
    if (!run.fails()) return true;
    ++tally.failures;
    ClaimFind find(property, run.error, run.check.text,
                   check_command(property.name, property.method, words_of(input.choices)));
    if (is_known(find)) {
      ++tally.known;
      return true;
    }
    // A hang was put to these choices already, and another run costs all its time again.
    const auto least = run.error == "hang"
                           ? Counterexample{input.choices, run.check, 0, true}
                           : served.least(property, run, {.is_over = [this] { return is_over(); }});
    if (least) find.set_least(*least);
    const SavedClaim saved = need(save_claim(claims_in(arguments_.output), find));
    if (!saved.is_new) {
      ++tally.known;
      return !is_over();
    }
    ++counts_.finds;
    tell(file, find, saved.path);
    return find.is_complete() || !is_over();
  }

  /// Whether a find of this failure that is shrunk to the end is in the folder, or elsewhere.
  bool is_known(const ClaimFind& find) const {
    const auto is_in = [&](const std::string& folder) {
      const auto saved = need(saved_claim(claims_in(folder), find));
      return saved && saved->is_complete();
    };
    return is_in(arguments_.output) || (!arguments_.known.empty() && is_in(arguments_.known));
  }

  void tell(const std::string& input, const ClaimFind& find, const std::string& path) const {
    const std::string outcome = find.error.empty() ? "refuted claim" : find.error;
    const bool fails_again = find.shrunk != Shrunk::kNot;
    const char* state = find.is_complete() ? ""
                        : fails_again      ? ", not shrunk to the end"
                                           : ", not shrunk";
    const auto row = [&](auto& archive) {
      archive.constant("row", "find");
      archive("input", input);
      archive("property", find.property);
      archive("outcome", outcome);
      archive("text", fails_again ? find.text : find.found);
      archive("reproduce", reproduction(find));
      archive("fails_again", fails_again);
      archive("cut_short", find.shrunk == Shrunk::kCutShort);
      archive("saved", path);
    };
    session_.say(row, fmt::format("{}: {}{}: {}\n", outcome, find.property, state, path));
  }

  const TriageArguments& arguments_;
  Session& session_;
  const Stopwatch watch_;
  TriageCounts counts_;
};

int run_triage(const TriageArguments& arguments, Session& session) {
  return TriageRun(arguments, session).run();
}

}  // namespace

void add_triage(CommandLine& line) {
  auto [command, options] = line.add<TriageArguments>(
      "triage", "Confirm, minimise, deduplicate and store what fuzzers found", run_triage);
  command.example("the findings of a fuzz target", "triage crash-* -o finds");
  options->methods.emplace_back("trad");
  command
      .texts("input", options->inputs,
             "Inputs of fuzz_query or fuzz_witnessed, case files (.csv among them), or folders of "
             "either")
      .required();
  Option target = command.text("--target NAME", options->target,
                               "The inputs are those of this other target, whose claims fail on "
                               "them; they go to `claims` in the folder");
  for (const Option& asked :
       add_methods(command, options->methods, "Methods to run, separated by commas")) {
    target.excludes(asked);
  }
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
