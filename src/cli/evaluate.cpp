#include "eval/evaluate.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/answer_row.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/evaluate_linear.hpp"
#include "cli/interrupt.hpp"
#include "cli/number_text.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "query/output_file.hpp"

namespace ccdfuzz {

namespace {

struct EvaluateArguments {
  std::vector<std::string> files;
  std::string methods = kDefaultMethods;
  std::string horizons;
  std::string linear;
  SearchFlags search;
  std::string folder;
  int threads = 1;
  bool json = false;
};

Result<EvaluateOptions> parse(const EvaluateArguments& options) {
  EvaluateOptions parsed;
  parsed.threads = options.threads;
  Result<std::vector<std::string>> methods = parse_method_list(options.methods);
  if (!methods) return tl::unexpected(methods.error());
  parsed.methods = std::move(*methods);
  const Result<SearchOptions> search = options.search.parse();
  if (!search) return tl::unexpected(search.error());
  parsed.search = *search;
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

nlohmann::ordered_json group_json(const EvaluatedGroup& group) {
  const Tally& tally = group.tally;
  nlohmann::ordered_json row = {{"class", group.contact}, {"t_max_factor", nullptr}};
  if (group.factor) row["t_max_factor"] = *group.factor;
  row.update({{"method", group.method},
              {"n", tally.n},
              {"positives", tally.positives},
              {"negatives", tally.negatives}});
  for (const Outcome outcome : kAllOutcomes) {
    row[std::string(name_of(outcome))] = tally.count(outcome);
  }
  row.update({{"mean_pops",
               tally.n == 0 ? 0 : static_cast<double>(tally.pops) / static_cast<double>(tally.n)},
              {"mean_seconds", tally.mean_seconds()},
              {"median_seconds", group.timings.median()},
              {"p99_seconds", group.timings.p99()}});
  return row;
}

/// The same numbers for a spreadsheet.
std::string groups_csv(const std::vector<EvaluatedGroup>& groups) {
  std::string header, lines;
  for (const EvaluatedGroup& group : groups) {
    header.clear();
    std::string line;
    const nlohmann::ordered_json row = group_json(group);
    for (const auto& [key, value] : row.items()) {
      const char* const comma = header.empty() ? "" : ",";
      header += comma + key;
      const std::string text = value.is_string() ? value.get<std::string>()
                               : value.is_null() ? ""
                                                 : value.dump();
      line += comma + csv_field(text);
    }
    lines += line + "\n";
  }
  return header + "\n" + lines;
}

/// One row for each answer, for Figs. 5, 8 and 9.
std::string answers_header() {
  return "case,class,kind,method,t_max,verdict,toi,outcome,pops,seconds\n";
}

std::string answers_line(const EvaluatedRow& row) {
  const Answer& answer = row.judged.answer;
  const Origin& origin = row.source->value.origin;
  const bool has_toi = answer.toi && answer.verdict != Verdict::kMiss;
  return fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_field(row.source->id),
                     csv_field(origin.contact), csv_field(origin.kind), row.method, row.t_max,
                     name_of(answer.verdict), has_toi ? fmt::format("{}", *answer.toi) : "",
                     name_of(row.judged.outcome), answer.pops, answer.seconds);
}

/// The report folder: answers.csv, tables.csv, tables.md; each appears whole or not at all.
class Report {
 public:
  static Result<Report> open(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return input_error(folder, "cannot make the folder: " + error.message());
    Report report(folder);
    Result<OutputFile> answers = OutputFile::create(report.path("answers.csv"));
    if (!answers) return tl::unexpected(answers.error());
    report.answers_ = std::move(*answers);
    report.add(answers_header());
    return report;
  }

  void add(const std::string& line) {
    if (written_) written_ = answers_->write(line);
  }

  /// What went wrong so far.
  const Result<void>& written() const { return written_; }

  Result<void> finish(const std::vector<EvaluatedGroup>& groups) {
    if (!written_) return written_;
    if (auto done = answers_->commit(); !done) return done;
    const Table performance = performance_table(groups), paper = paper_table(groups);
    if (auto done =
            write_file(path("tables.md"), performance.to_markdown() + "\n" + paper.to_markdown());
        !done) {
      return done;
    }
    std::string lines;
    for (const EvaluatedGroup& group : groups) lines += group_json(group).dump() + "\n";
    if (auto done = write_file(path("groups.jsonl"), lines); !done) return done;
    return write_file(path("performance.csv"), groups_csv(groups));
  }

 private:
  explicit Report(std::string folder) : folder_(std::move(folder)) {}

  std::string path(const char* name) const { return folder_ + "/" + name; }

  std::string folder_;
  std::optional<OutputFile> answers_;
  Result<void> written_;
};

Result<int> run_evaluate(const EvaluateArguments& options) {
  const Result<EvaluateOptions> parsed = parse(options);
  if (!parsed) return tl::unexpected(parsed.error());
  if (!options.linear.empty()) return run_evaluate_linear(options.linear, *parsed, options.json);
  if (options.files.empty()) return input_error("dataset", "is required");
  const Result<std::vector<NamedCase>> cases = read_all_checked(options.files);
  if (!cases) return tl::unexpected(cases.error());
  std::optional<Report> report;
  if (!options.folder.empty()) {
    Result<Report> opened = Report::open(options.folder);
    if (!opened) return tl::unexpected(opened.error());
    report = std::move(*opened);
  }

  Progress progress;
  const std::atomic<bool>& interrupted = catch_interrupts();
  const std::vector<EvaluatedGroup> groups = evaluate(
      *cases, *parsed,
      [&](const EvaluatedRow& row, double share) {
        if (report) report->add(answers_line(row));
        progress.show(share, fmt::format("{} {}", row.source->value.origin.contact, row.method));
      },
      &interrupted);
  progress.clear();

  if (options.json) {
    for (const EvaluatedGroup& group : groups) print_json(group_json(group));
  } else {
    const bool colour = wants_colour(stdout);
    print_out(performance_table(groups).to_text(colour));
    print_out("\nBeside the paper's Table 2 (RP+RN):\n");
    print_out(paper_table(groups).to_text(colour));
  }
  if (report) {
    if (const Result<void> done = report->finish(groups); !done) {
      return tl::unexpected(done.error());
    }
  }
  return interrupted ? interrupted_exit_code() : kDone;
}

}  // namespace

void add_evaluate(CommandLine& line) {
  auto [command, options] = line.add<EvaluateArguments>(
      "evaluate", "Time and judge methods on data sets (the paper's Tables 1 to 3)", run_evaluate);
  const Option dataset =
      command.texts("dataset", options->files, "Case files: .json, .jsonl or .jsonl.zst");
  command
      .text("--linear", options->linear,
            "Instead: all edge-edge and vertex-face query CSVs under this folder (the paper's "
            "Table 3), judged by their exact truth")
      .excludes(dataset);
  command.text("--methods", options->methods, "Methods to ask, separated by commas");
  command.text("--t-max-factors", options->horizons,
               "Ask positive cases up to these multiples of the contact's time instead of their "
               "own t_max, e.g. 1,1+2^-30,1.5,2: past the contact, late answers show");
  options->search.add_to(command);
  command.text("-o,--output", options->folder,
               "Folder for answers.csv, performance.csv, groups.jsonl and tables.md");
  add_threads(command, options->threads);
  command.flag("--json", options->json, "One JSON object per class and method");
}

}  // namespace ccdfuzz
