#include "hunt/triage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/number_text.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "corpus/entries.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "query/input_bytes.hpp"

namespace ccdfuzz {

namespace {

namespace fs = std::filesystem;

struct TriageArguments {
  std::vector<std::string> inputs;
  std::string output = "finds";
  std::string known;
  std::string methods = std::string(kDefaultMethods) + ",trad";
  std::string seconds = "60";
  SearchFlags search;
  bool json = false;
  bool remove = false;
};

/// The files that the arguments name, in order; folders stand for what is in them.
Result<std::vector<std::string>> files_of(const std::vector<std::string>& inputs) {
  std::vector<std::string> files;
  for (const std::string& input : inputs) {
    std::error_code error;
    if (!fs::exists(input, error)) return input_error(input, "no such file or folder");
    if (!fs::is_directory(input, error)) {
      files.push_back(input);
      continue;
    }
    std::vector<std::string> inside;
    for (const auto& entry : fs::recursive_directory_iterator(input, error)) {
      if (entry.is_regular_file()) inside.push_back(entry.path());
    }
    if (error) return input_error(input, "cannot be read: " + error.message());
    std::ranges::sort(inside);
    std::ranges::move(inside, std::back_inserter(files));
  }
  return files;
}

/// The cases of a file: a case file, or an input of a fuzz target. Errors: it is neither.
Result<std::vector<NamedCase>> cases_of(const std::string& path) {
  if (case_file_kind(path)) return read_all_checked({path});
  std::ifstream in(path, std::ios::binary);
  if (!in) return input_error(path, "cannot be read");
  const std::vector<char> content{std::istreambuf_iterator<char>(in), {}};
  const std::vector<std::uint8_t> bytes(content.begin(), content.end());
  const auto query = query_of(bytes);
  if (!query) {
    return input_error(path, "is neither a case file nor an input of fuzz_query or fuzz_witnessed");
  }
  // fuzz_witnessed makes a broken contact whole and asks that; fuzz_query asks what stands there.
  const auto whole = witnessed_query_of(bytes);
  std::vector<NamedCase> cases;
  const auto add = [&](Case value) {
    value.origin.generator = "mutant";
    value.origin.note = "by fuzzing";
    cases.push_back({path, std::move(value)});
  };
  if (!whole || whole->query != *query) {
    Case value;
    value.query = *query;
    add(std::move(value));
  }
  if (whole) add(case_of(*whole));
  return cases;
}

void tell(const TriageFind& find, const std::string& id, bool json) {
  if (json) {
    print_json({{"row", "find"},
                {"input", id},
                {"class", find.value.origin.contact},
                {"method", find.method},
                {"outcome", name_of(find.outcome)},
                {"error", find.error},
                {"loss", find.loss},
                {"address", content_address(find.value.query)}});
  } else {
    const std::string& how = find.error.empty() ? find.loss : find.error;
    print_out(fmt::format("{} {} by {}: {}\n", find.value.origin.contact, name_of(find.outcome),
                          find.method, how.empty() ? "nothing to trace" : how));
  }
}

Result<void> know_all(Triage& triage, const Result<std::vector<NamedCase>>& entries) {
  if (!entries) return tl::unexpected(entries.error());
  for (const NamedCase& entry : *entries) triage.know(entry.value);
  return {};
}

Result<int> run_triage(const TriageArguments& options) {
  TriageOptions parsed;
  Result<std::vector<std::string>> methods = parse_method_list(options.methods);
  if (!methods) return tl::unexpected(methods.error());
  const Result<SearchOptions> search = options.search.parse();
  if (!search) return tl::unexpected(search.error());
  const Result<double> seconds = parse_seconds("--seconds", options.seconds);
  if (!seconds) return tl::unexpected(seconds.error());
  const Result<std::vector<std::string>> files = files_of(options.inputs);
  if (!files) return tl::unexpected(files.error());
  Result<Store> store = Store::open(options.output);
  if (!store) return tl::unexpected(store.error());

  const std::atomic<bool>& interrupted = catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  const auto is_over = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return interrupted || passed.count() > *seconds;
  };
  parsed.methods = *std::move(methods);
  parsed.search = *search;
  parsed.stop = is_over;
  Triage triage(*store, std::move(parsed));
  if (auto known = know_all(triage, store->load()); !known) return tl::unexpected(known.error());
  if (!options.known.empty()) {
    const Result<void> known = know_all(triage, load_corpus(options.known));
    if (!known) return tl::unexpected(known.error());
  }

  Progress progress;
  std::uint64_t finds = 0, done = 0, unread = 0;
  for (const std::string& file : *files) {
    const Result<std::vector<NamedCase>> cases = cases_of(file);
    if (!cases) {
      progress.clear();
      fmt::print(stderr, "ccdfuzz: {}; it is left as it is\n", cases.error().message());
      ++unread;
      continue;
    }
    for (const NamedCase& input : *cases) {
      if (is_over()) break;
      const Result<void> added = triage.add(input.value, [&](const TriageFind& find) {
        progress.clear();
        tell(find, input.id, options.json);
        ++finds;
      });
      if (!added) return tl::unexpected(added.error());
    }
    if (is_over()) break;
    ++done;
    if (std::error_code error; options.remove && !fs::remove(file, error)) {
      return input_error(file, "cannot be removed: " + error.message());
    }
    progress.show(static_cast<double>(done) / static_cast<double>(files->size()),
                  fmt::format("{} new", finds), done, "inputs");
  }
  progress.clear();
  const TriageTally& tally = triage.tally();
  if (options.json) {
    print_json({{"row", "summary"},
                {"files", files->size()},
                {"files_done", done},
                {"files_unread", unread},
                {"inputs", tally.inputs},
                {"failures", tally.failures},
                {"known", tally.known},
                {"harmless", tally.saved},
                {"finds", finds}});
  } else {
    print_out(fmt::format(
        "{} of {} files: {} failures, {} of them like one that is stored; {} inputs on which "
        "no full run fails; {} new in {}\n",
        done, files->size(), tally.failures, tally.known, tally.saved, finds, options.output));
  }
  if (interrupted) return interrupted_exit_code();
  return unread > 0 ? kBadInput : kDone;
}

}  // namespace

void add_triage(CommandLine& line) {
  auto [command, options] = line.add<TriageArguments>(
      "triage", "Confirm, shrink, tell apart and store what fuzzers found", run_triage);
  command
      .texts("input", options->inputs,
             "Inputs of fuzz_query or fuzz_witnessed, case files, or folders of either")
      .required();
  command.text("-o,--output", options->output, "Folder to store counterexamples in");
  command.text("--known", options->known, "A corpus, whose failures are not stored again");
  command.text("--methods", options->methods, "Methods to ask, separated by commas");
  command.text("--seconds", options->seconds, "What is not done by then is left undone");
  options->search.max_pops = 10'000;
  options->search.add_budget_to(command);
  command.flag("--remove", options->remove, "Removes each input file that is done");
  command.flag("--json", options->json, "One JSON object a find, and a summary");
}

}  // namespace ccdfuzz
