#include <fmt/format.h>

#include "base/table.hpp"
#include "case/case_files.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/imported.hpp"

namespace ccdfuzz {

namespace {

struct ImportArguments {
  std::vector<std::string> files;
  std::string output;
  std::string layout;
  std::string truths;
  bool round = false;
  bool json = false;
};

const char* contact_text(const std::optional<bool>& collides) {
  return !collides ? "" : *collides ? "contact" : "none";
}

struct ImportCounts {
  std::uint64_t queries = 0, hits = 0, misses = 0, undecided = 0;
  std::uint64_t labels = 0, wrong_labels = 0;
  std::uint64_t rounded_values = 0, rounded_queries = 0, changed = 0;

  /// Adds a query; true if it is one that people want to see.
  bool add(const Imported& query) {
    const std::optional<bool>& asked = query.value.truth.collides;
    ++queries;
    ++(!asked ? undecided : *asked ? hits : misses);
    rounded_values += query.rounded;
    if (query.rounded > 0) ++rounded_queries;
    if (query.label && query.collides) ++labels;
    if (query.label_is_wrong()) ++wrong_labels;
    if (query.rounding_changed_the_truth()) ++changed;
    return query.label_is_wrong() || query.rounding_changed_the_truth();
  }

  std::string summary() const {
    std::string text = fmt::format("{} queries: {} hits, {} misses", queries, hits, misses);
    if (undecided > 0) text += fmt::format(", {} left to prove", undecided);
    if (labels > 0) text += fmt::format("; {} of {} labels are wrong", wrong_labels, labels);
    if (rounded_values > 0) {
      text += fmt::format("; {} values of {} queries rounded, which changed the truth of {}",
                          rounded_values, rounded_queries, changed);
    }
    return text + "\n";
  }
};

Result<CsvLayout> import_layout_of(const ImportArguments& options, const std::string& path) {
  if (!options.layout.empty()) return parse_choice("--as", options.layout, kAllCsvLayouts);
  if (const auto told = csv_layout_of_path(path)) return *told;
  return input_error(path, "does not tell its layout: name it with --as");
}

Result<int> run_import(const ImportArguments& options) {
  if (!options.truths.empty() && options.files.size() > 1) {
    return input_error("--truths", "goes with one file");
  }
  std::vector<CsvLayout> layouts;
  for (const std::string& path : options.files) {
    const Result<CsvLayout> layout = import_layout_of(options, path);
    if (!layout) return tl::unexpected(layout.error());
    layouts.push_back(*layout);
  }
  Result<CaseWriter> writer = CaseWriter::open(options.output);
  if (!writer) return tl::unexpected(writer.error());
  Table table({{"query", Align::kLeft},
               {"label", Align::kLeft},
               {"in the file", Align::kLeft},
               {"as rounded", Align::kLeft}});
  ImportCounts counts;
  Progress progress;
  std::uint64_t imported = 0;
  const std::atomic<bool>& interrupted = catch_interrupts();
  for (size_t f = 0; f < options.files.size(); ++f) {
    Result<CsvReader> reader = CsvReader::open(options.files[f], layouts[f], options.truths);
    if (!reader) return tl::unexpected(reader.error());
    for (std::uint64_t index = 0;; ++index) {
      if (interrupted) return interrupted_exit_code();
      const Result<std::optional<CsvQuery>> next = reader->next();
      if (!next) return tl::unexpected(next.error());
      if (!*next) break;
      const Result<Imported> query = import_case(**next, options.round, index);
      if (!query) return tl::unexpected(query.error());
      const bool notable = counts.add(*query);
      const std::optional<bool>& asked = query->value.truth.collides;
      if (options.json) {
        nlohmann::ordered_json row = {{"query", query->id}, {"label", nullptr}};
        if (query->label) row["label"] = *query->label;
        row["in_file"] = row["as_rounded"] = nullptr;
        if (query->collides) row["in_file"] = *query->collides;
        if (asked) row["as_rounded"] = *asked;
        row["rounded"] = query->rounded;
        print_json(row);
      } else if (notable) {
        table.add_row({{query->id},
                       {contact_text(query->label)},
                       {contact_text(query->collides), Emphasis::kBad},
                       {contact_text(asked)}});
      }
      if (const auto written = writer->write(query->value); !written) {
        return tl::unexpected(written.error());
      }
      progress.show(static_cast<double>(f) / static_cast<double>(options.files.size()), query->id,
                    ++imported, "queries");
    }
  }
  progress.clear();
  if (const auto finished = writer->finish(); !finished) return tl::unexpected(finished.error());
  if (!options.json) {
    if (table.row_count() > 0) {
      print_table(table);
      print_out("\n");
    }
    print_out(counts.summary());
  }
  return kDone;
}

}  // namespace

void add_import(CommandLine& line) {
  auto [command, options] = line.add<ImportArguments>(
      "import", "Read query CSVs, decide linear queries exactly, and list wrong labels",
      run_import);
  command
      .texts("csv", options->files,
             "Files of rows xn,xd,yn,yd,zn,zd[,truth]: 8 a linear query, 24 a curved one")
      .required();
  command
      .text("-o,--output", options->output, "File to write: .jsonl, .jsonl.zst, or .json for one")
      .required();
  command
      .text("--as", options->layout,
            "edge-edge, vertex-face or curved; by default what the path of each file says")
      .without_default();
  command.text("--truths", options->truths, "JSON list of truths of a file without that column");
  command.flag("--round", options->round,
               "Take the nearest double for numbers and ways that are none, and count them");
  command.flag("--json", options->json, "One JSON object per query");
}

}  // namespace ccdfuzz
