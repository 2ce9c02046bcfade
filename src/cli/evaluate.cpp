#include "eval/evaluate.hpp"

#include <fmt/format.h>

#include <map>

#include "base/csv.hpp"
#include "base/journal.hpp"
#include "base/number_text.hpp"
#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/evaluate_linear.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/refusals.hpp"
#include "cli/terminal.hpp"
#include "eval/evaluation_folder.hpp"
#include "eval/paper_tables.hpp"
#include "finds/data_set_address.hpp"
#include "method/method.hpp"
#include "report/rows.hpp"

namespace ccdfuzz {

namespace {

struct EvaluateArguments {
  std::vector<std::string> files;
  std::vector<std::string> methods = default_methods();
  std::string horizons;
  std::string linear;
  SearchFlags search;
  std::string shard;
  std::string folder;
  std::string page;  ///< folder
  int threads = 1;
  bool json = false;
};

Result<EvaluateOptions> parse(const EvaluateArguments& options) {
  EvaluateOptions parsed;
  parsed.threads = options.threads;
  parsed.methods = options.methods;
  parsed.search = options.search.options();
  parsed.search_for = [flags = options.search](const Case& value) {
    return flags.options_for(value);
  };
  if (!options.horizons.empty()) {
    Result<std::vector<double>> factors = parse_numbers("--t-max-factors", options.horizons);
    if (!factors) return tl::unexpected(factors.error());
    for (const double factor : *factors) {
      if (factor < 1) {
        return input_error("--t-max-factors",
                           fmt::format("{} is below 1: the contact would be out of reach", factor));
      }
    }
    std::vector<double> sorted = *factors;
    std::ranges::sort(sorted);
    if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end()) {
      return input_error("--t-max-factors", fmt::format("{} stands there twice", *twice));
    }
    parsed.horizon_factors = std::move(*factors);
  }
  return parsed;
}

/// "0.0001", and whether a case is asked at a precision of its own instead.
std::string precision_text(const EvaluateOptions& options, const std::vector<NamedCase>& cases) {
  const bool is_own = std::ranges::any_of(cases, [&](const NamedCase& named) {
    return options.search_for(named.value).precision != options.search.precision;
  });
  return fmt::format("{}{}", options.search.precision, is_own ? " or the case's own" : "");
}

/// What must be the same for answers to belong together; the share comes last.
Journal::Header evaluation_header(const EvaluateOptions& options,
                                  const std::vector<NamedCase>& cases) {
  const SearchOptions& search = options.search;
  return {{"run", "evaluate"},
          {"ccdfuzz", CCDFUZZ_VERSION},
          {"cases", fmt::format("{} of address {}", cases.size(), data_set_address(cases))},
          {"--methods", fmt::format("{}", fmt::join(options.methods, ","))},
          {"--t-max-factors", fmt::format("{}", fmt::join(options.horizon_factors, ","))},
          {"--precision", precision_text(options, cases)},
          {"--max-pops", fmt::format("{}", search.max_pops)},
          {"--max-seconds", search.max_seconds < SearchOptions::kNoTimeLimit
                                ? fmt::format("{}", search.max_seconds)
                                : "none"},
          {"--shard", fmt::format("{}/{}", options.shard.index, options.shard.of)}};
}

EvaluationRun evaluation_run(const EvaluateOptions& options, const std::vector<NamedCase>& cases) {
  std::string asked;
  Journal::Header header = evaluation_header(options, cases);
  header.pop_back();
  for (const auto& [name, value] : header) {
    asked += fmt::format("{}{} {}", asked.empty() ? "" : "; ", name, value);
  }
  return {asked, options.methods, options.shard};
}

/// How the data sets were made, as far as it is on record. A record whose counts are not those of
/// the cases belongs to something else that had the name.
Result<std::vector<GenerationCost>> costs_of_sets(const std::vector<std::string>& files,
                                                  const std::vector<NamedCase>& cases) {
  std::map<std::pair<std::string, std::string>, std::uint64_t> counts;
  for (const NamedCase& named : cases) {
    ++counts[{named.value.origin.contact, named.value.origin.kind}];
  }
  std::vector<GenerationCost> costs;
  for (const std::string& file : files) {
    const auto record = read_generation(generation_path(file));
    if (!record) return tl::unexpected(record.error());
    if (*record) merge_costs(costs, (*record)->costs);
  }
  for (const GenerationCost& cost : costs) {
    std::uint64_t count = 0;
    for (const std::string kind : {"RP", "RN", "NHP", "NMN"}) {
      if (("+" + cost.kind + "+").find("+" + kind + "+") != std::string::npos) {
        count += counts[{cost.contact, kind}];
      }
    }
    if (count != cost.cases) return std::vector<GenerationCost>();
  }
  return costs;
}

void print_evaluation(const std::vector<EvaluatedGroup>& groups,
                      const std::vector<GenerationCost>& costs, bool json) {
  if (json) {
    for (const EvaluatedGroup& group : groups) print_out(to_json(group) + "\n");
    return;
  }
  bool first = true;
  for (const auto& [title, table] : evaluation_tables(groups, costs)) {
    if (!first) print_out("\n" + title + ":\n");
    first = false;
    print_table(table);
  }
  print_refusals(groups);
}

std::string progress_note(const AnswerRecord& record) {
  return fmt::format("{} {}", record.contact, record.method);
}

Result<void> write_evaluation_page(ReportRows& rows, const std::vector<GenerationCost>& costs,
                                   const std::vector<std::string>& methods,
                                   const EvaluateArguments& options) {
  ReportPage page;
  page.title = options.files.size() == 1
                   ? fmt::format("Evaluation of {}", options.files.front())
                   : fmt::format("Evaluation of {} files", options.files.size());
  page.command = fmt::format("{} evaluate … --methods {} --report {}", shell_word(program_name()),
                             fmt::join(methods, ","), shell_word(options.page));
  rows.finish(page, costs);
  page.plugins = plugins_among(methods);
  return write_report(page, options.page, options.threads);
}

/// Into a folder, by a journal of the answers in it, so that a killed run goes on.
Result<int> evaluate_into_folder(const std::vector<NamedCase>& cases, EvaluateOptions options,
                                 const EvaluateArguments& flags,
                                 const std::vector<GenerationCost>& costs) {
  const EvaluationRun asked = evaluation_run(options, cases);
  // Whether the result can be written is to be known before the work is done.
  if (auto trial = EvaluationFolder::open(flags.folder, asked); !trial) {
    return tl::unexpected(trial.error());
  }
  const std::string path = Journal::path_for(EvaluationFolder::answers_path(flags.folder));
  const std::atomic<bool>& interrupted = catch_interrupts();
  Result<Journal> journal = Journal::open(path, evaluation_header(options, cases));
  if (!journal) return tl::unexpected(journal.error());
  options.skip = journal->size();
  if (options.skip > 0) {
    print_err(fmt::format("ccdfuzz: going on behind {} answers in {}\n", options.skip, path));
  }
  Progress progress;
  Result<void> kept;
  std::atomic<bool> stop = false;
  const Result<bool> complete = evaluate(
      cases, options,
      [&](const AnswerRecord& record, double share) {
        if (kept) kept = journal->append(csv_row(record));
        if (!kept || interrupted) stop = true;
        progress.show(share, progress_note(record), journal->size() - options.skip, "answers");
      },
      &stop);
  progress.clear();
  if (!kept) return tl::unexpected(kept.error());
  if (!complete) return tl::unexpected(complete.error());
  if (!*complete) {
    print_err(
        fmt::format("ccdfuzz: interrupted after {} answers; the same command goes on from there\n",
                    journal->size()));
    return interrupted_exit_code();
  }
  note_words(cases, "evaluate");
  Result<EvaluationFolder> folder = EvaluationFolder::open(flags.folder, asked);
  if (!folder) return tl::unexpected(folder.error());
  ReportRows page;
  Result<void> done = journal->for_each([&](std::string_view line) -> Result<void> {
    const Result<AnswerRecord> record = from_csv_row<AnswerRecord>(line, path);
    if (!record) return tl::unexpected(record.error());
    if (!flags.page.empty()) {
      const NamedCase& named = cases.at(record->index);
      page.add(*record, named, options.search_for(named.value).precision);
    }
    return folder->add(*record);
  });
  if (done) done = folder->finish(costs);
  if (done && !flags.page.empty())
    done = write_evaluation_page(page, costs, options.methods, flags);
  if (done) done = journal->remove();
  if (!done) return tl::unexpected(done.error());
  print_evaluation(folder->groups(), costs, flags.json);
  return kDone;
}

Result<int> run_evaluate(const EvaluateArguments& options) {
  Result<EvaluateOptions> parsed = parse(options);
  if (!parsed) return tl::unexpected(parsed.error());
  if (!options.linear.empty()) {
    return run_evaluate_linear(options.linear, *parsed, options.json, options.page);
  }
  if (options.files.empty()) return input_error("dataset", "is required");
  const Result<std::vector<NamedCase>> cases = read_cases(options.files);
  if (!cases) return tl::unexpected(cases.error());
  const Result<Shard> shard = parse_shard(options.shard, cases->size(), "cases");
  if (!shard) return tl::unexpected(shard.error());
  parsed->shard = *shard;
  const auto costs = costs_of_sets(options.files, *cases);
  if (!costs) return tl::unexpected(costs.error());
  if (!options.folder.empty()) return evaluate_into_folder(*cases, *parsed, options, *costs);

  Progress progress;
  const std::atomic<bool>& interrupted = catch_interrupts();
  Groups groups(parsed->methods);
  ReportRows page;
  std::uint64_t answers = 0;
  const Result<bool> complete = evaluate(
      *cases, *parsed,
      [&](const AnswerRecord& record, double share) {
        groups.add(record);
        if (!options.page.empty()) {
          const NamedCase& named = cases->at(record.index);
          page.add(record, named, parsed->search_for(named.value).precision);
        }
        progress.show(share, progress_note(record), ++answers, "answers");
      },
      &interrupted);
  progress.clear();
  if (!complete) return tl::unexpected(complete.error());
  note_words(*cases, "evaluate");
  print_evaluation(groups.in_order(), *costs, options.json);
  if (!options.page.empty()) {
    if (auto done = write_evaluation_page(page, *costs, parsed->methods, options); !done) {
      return tl::unexpected(done.error());
    }
  }
  return interrupted ? interrupted_exit_code() : kDone;
}

}  // namespace

void add_evaluate(CommandLine& line) {
  auto [command, options] = line.add<EvaluateArguments>(
      "evaluate", "Time and judge methods on data sets (the paper's Tables 1, 2 and 4)",
      run_evaluate);
  const Option dataset =
      command.texts("dataset", options->files, "Case files: .json, .jsonl or .jsonl.zst");
  Option linear = command.text(
      "--linear", options->linear,
      "Instead: all edge-edge and vertex-face query CSVs under this folder (the paper's Table 3), "
      "judged by their exact truth");
  linear.excludes(dataset);
  add_methods(command, options->methods, "Methods to ask, separated by commas");
  command.text("--t-max-factors", options->horizons,
               "Ask positive cases up to these multiples of the contact's time instead of their "
               "own t_max, e.g. 1,1+2^-30,1.5,2: past the contact, late answers show");
  options->search.add_to(command);
  linear.excludes(add_shard(command, options->shard));
  linear.excludes(command.text(
      "-o,--output", options->folder,
      "Folder for all answers (answers.csv), their counts (rows.jsonl) and the tables "
      "(tables.md), which `report` shows; killed, the same command goes on where it was"));
  command.text("--report", options->page,
               "Folder for a page (index.html) of tables, figures and watchable failures");
  command.threads(options->threads);
  command.flag("--json", options->json, "One JSON object per class, kinds and method");
  command.max_work();
}

}  // namespace ccdfuzz
