#include <fmt/format.h>

#include "case/case_files.hpp"
#include "cli/command.hpp"
#include "cli/session.hpp"
#include "eval/imported.hpp"

namespace ccdfuzz {

namespace {

struct ImportOptions {
  std::vector<std::string> files;
  std::string output;
  std::optional<CsvLayout> layout;
  std::string truths;
  bool round = false;
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
    return text;
  }
};

/// The layouts of the files. Throws BadInput: one does not tell it, and no --as does.
std::vector<CsvLayout> layouts_of(const ImportOptions& options) {
  std::vector<CsvLayout> layouts;
  for (const std::string& path : options.files) {
    const auto layout = options.layout ? options.layout : csv_layout_of_path(path);
    if (!layout) throw BadInput{{path, "does not tell its layout: name it with --as"}};
    layouts.push_back(*layout);
  }
  return layouts;
}

int run_import(const ImportOptions& options, Session& session) {
  if (!options.truths.empty() && options.files.size() > 1) {
    throw BadInput{{"--truths", "goes with one file"}};
  }
  const std::vector<CsvLayout> layouts = layouts_of(options);
  CaseWriter writer = need(CaseWriter::open(options.output));
  session.begin_table({{"query", Align::kLeft},
                       {"label", Align::kLeft},
                       {"in the file", Align::kLeft},
                       {"as rounded", Align::kLeft}});
  ImportCounts counts;
  const std::atomic<bool>& interrupted = catch_interrupts();
  for (size_t f = 0; f < options.files.size(); ++f) {
    CsvReader reader = need(CsvReader::open(options.files[f], layouts[f], options.truths));
    const double share = static_cast<double>(f) / static_cast<double>(options.files.size());
    for (std::uint64_t index = 0;; ++index) {
      if (interrupted) return interrupted_exit_code();
      const std::optional<CsvQuery> next = need(reader.next());
      if (!next) break;
      const Imported query = need(import_case(*next, options.round, index));
      if (counts.add(query) || session.json) {
        session.show(query, false, [](const Imported& row) -> std::vector<TableCell> {
          return {{row.id},
                  {contact_text(row.label)},
                  {contact_text(row.collides), Emphasis::kBad},
                  {contact_text(row.value.truth.collides)}};
        });
      }
      need(writer.write(query.value));
      session.progress().show(share, query.id, counts.queries, "queries");
    }
  }
  need(writer.finish());
  session.end_table(true);
  session.summary(counts.summary());
  return kDone;
}

}  // namespace

void add_import(CommandLine& line) {
  auto [command, options] = line.add<ImportOptions>(
      "import", "Read query CSVs, decide linear queries exactly, and list wrong labels",
      run_import);
  command
      .texts("csv", options->files,
             "Files of rows xn,xd,yn,yd,zn,zd[,truth]: 8 a linear query, 24 a curved one")
      .required();
  command
      .text("-o,--output", options->output, "File to write: .jsonl, .jsonl.zst, or .json for one")
      .required();
  command.choice("--as", options->layout,
                 "edge-edge, vertex-face or curved; by default what the path of each file says");
  command.text("--truths", options->truths, "JSON list of truths of a file without that column");
  command.flag("--round", options->round,
               "Take the nearest double for numbers and ways that are none, and count them");
  command.json("One JSON object per query");
}

}  // namespace ccdfuzz
