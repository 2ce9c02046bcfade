#include <fmt/format.h>

#include "base/number_text.hpp"
#include "certify/linear/first_contact.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/data_set.hpp"
#include "cli/session.hpp"
#include "method/ask.hpp"

namespace ccdfuzz {

namespace {

struct ImportOptions {
  std::vector<std::string> files;
  std::string output;
  CsvOptions csv{.round = false, .any_name = true};
};

/// How a query's truth compares with what its file says.
struct ImportedRow {
  std::string id;
  std::optional<bool> label;     ///< what the file says
  std::optional<bool> in_file;   ///< what is so of its numbers, if the query is linear
  std::optional<bool> collides;  ///< what is so of the doubles nearest to them
  std::uint64_t rounded = 0;     ///< numbers that are no doubles

  static void fields(auto& archive, auto& row) {
    archive("query", row.id);
    archive("label", row.label);
    archive("in_file", row.in_file);
    archive("as_rounded", row.collides);
    archive("rounded", row.rounded);
  }

  bool label_is_wrong() const { return label && in_file && *label != *in_file; }
  bool rounding_changed_the_truth() const { return in_file && collides != in_file; }
};

ImportedRow imported(NamedCase& named) {
  decide_unknown(named);
  const CsvQuery& rows = *named.rows;
  const auto& more = named.value.origin.more;
  const auto rounded = more.find("rounded");
  ImportedRow row{named.id, rows.label, {}, named.value.truth.collides};
  if (rounded != more.end()) row.rounded = need(parse_whole("rounded", rounded->second));
  if (row.collides) {
    row.in_file =
        row.rounded == 0 ? *row.collides : linear::first_contact(rows.patches(), 1).has_value();
  }
  return row;
}

const char* contact_text(const std::optional<bool>& collides) {
  return !collides ? "" : *collides ? "contact" : "none";
}

struct ImportCounts {
  std::uint64_t queries = 0, hits = 0, misses = 0, undecided = 0;
  std::uint64_t labels = 0, wrong_labels = 0;
  std::uint64_t changed = 0;

  /// Adds a query; true if it is one that people want to see.
  bool add(const ImportedRow& query) {
    ++queries;
    ++(!query.collides ? undecided : *query.collides ? hits : misses);
    if (query.label && query.in_file) ++labels;
    if (query.label_is_wrong()) ++wrong_labels;
    if (query.rounding_changed_the_truth()) ++changed;
    return query.label_is_wrong() || query.rounding_changed_the_truth();
  }

  std::string summary() const {
    std::string text = fmt::format("{}: {}, {}", counted(queries, "query", "queries"),
                                   counted(hits, "hit", "hits"), counted(misses, "miss", "misses"));
    if (undecided > 0) text += fmt::format(", {} left to prove", undecided);
    if (labels > 0) text += fmt::format("; {} of {} labels are wrong", wrong_labels, labels);
    if (changed > 0) text += fmt::format("; rounding changed the truth of {}", changed);
    return text;
  }
};

int run_import(const ImportOptions& options, Session& session) {
  const std::vector<std::string> files = need(case_files(options.files));
  if (!options.csv.truths.empty() && files.size() > 1) {
    throw BadInput{{"--truths", "goes with one file"}};
  }
  MadeSet set(options.output);
  CsvOptions csv = options.csv;
  csv.round_ways = csv.round;
  session.begin_table({{"query", Align::kLeft},
                       {"label", Align::kLeft},
                       {"in the file", Align::kLeft},
                       {"as rounded", Align::kLeft}});
  ImportCounts counts;
  session.each_case<ImportedRow>(
      CaseStream(files, csv), [](NamedCase& named) { return imported(named); },
      [&](const NamedCase& named, const ImportedRow& query) {
        if (counts.add(query) || session.json) {
          session.show(query, [&]() -> std::vector<TableCell> {
            return {{query.id},
                    {contact_text(query.label)},
                    {contact_text(query.in_file), true},
                    {contact_text(query.collides)}};
          });
        }
        need(set.writer.write(named.value));
      });
  if (session.interrupted()) {
    return session.end_unwritten(counts.queries, "queries", options.output);
  }
  set.finish();
  session.end_table(true);
  session.summary(counts.summary());
  return kDone;
}

}  // namespace

void add_import(CommandLine& line) {
  auto [command, options] = line.add<ImportOptions>(
      "import", "Read query CSVs, decide linear queries exactly, list wrong labels", run_import);
  command.example("a file of the public samples",
                  "import queries.csv --as edge-edge -o queries.jsonl.zst");
  command
      .texts("csv", options->files,
             "Files of rows xn,xd,yn,yd,zn,zd[,truth], 8 per linear query, 24 per curved one, or "
             "folders of .csv")
      .required();
  command
      .text("-o,--output FILE", options->output,
            "File to write: .jsonl, .jsonl.zst, or .json for one")
      .in("Results")
      .required();
  command.choice("--as LAYOUT", options->csv.layout,
                 "edge-edge, vertex-face or curved; by default what the path of each file says");
  command.text("--truths FILE", options->csv.truths,
               "JSON list of truths of a file without that column");
  command.flag("--round", options->csv.round,
               "Take the nearest double for numbers and ways that are none, and count them");
  command.json("One JSON object per query");
  command.max_work();
  command.threads();
}

}  // namespace ccdfuzz
