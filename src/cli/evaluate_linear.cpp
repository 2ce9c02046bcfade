#include "cli/evaluate_linear.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/refusals.hpp"
#include "cli/terminal.hpp"
#include "eval/linear_table.hpp"
#include "report/report.hpp"

namespace ccdfuzz {

namespace {

nlohmann::ordered_json linear_group_json(const LinearGroup& group) {
  const Tally& tally = group.tally;
  nlohmann::ordered_json row = {{"queries", name_of(group.layout)},
                                {"method", group.method},
                                {"n", tally.n},
                                {"positives", tally.positives},
                                {"negatives", tally.negatives}};
  for (const Outcome outcome : kAllOutcomes) {
    row[std::string(name_of(outcome))] = tally.count(outcome);
  }
  row.update({{"mean_seconds", tally.mean_seconds()},
              {"median_seconds", group.timings.median()},
              {"p99_seconds", group.timings.p99()}});
  return row;
}

nlohmann::ordered_json notable_json(const Imported& query) {
  nlohmann::ordered_json row = {{"query", query.id}, {"label", nullptr}};
  if (query.label) row["label"] = *query.label;
  row["in_file"] = *query.collides;
  row["as_rounded"] = *query.value.truth.collides;
  row["rounded"] = query.rounded;
  return row;
}

std::string notable_text(const Imported& query) {
  const auto text = [](bool collides) { return collides ? "a contact" : "no contact"; };
  if (query.label_is_wrong()) {
    return fmt::format("{}: labelled {}, but there is {}\n", query.id, text(*query.label),
                       text(*query.collides));
  }
  return fmt::format("{}: {}, but {} in the nearest doubles\n", query.id, text(*query.collides),
                     text(*query.value.truth.collides));
}

Result<void> write_linear_page(const std::string& folder, const LinearReport& report,
                               const EvaluateOptions& options, const std::string& page_folder) {
  ReportPage page;
  page.title = fmt::format("Linear queries of {}", folder);
  page.command = command_line();
  for (const LinearGroup& group : report.groups) {
    page.groups.push_back({std::string(name_of(group.layout)), "", std::nullopt, group.method,
                           group.tally, group.timings});
  }
  page.tables.push_back(
      report_table("table-3", "Table 3. Linear queries", linear_table(report.groups)));
  page.plugins = plugins_among(options.methods);
  return write_report(page, page_folder, options.threads);
}

}  // namespace

Result<int> run_evaluate_linear(const std::string& folder, const EvaluateOptions& options,
                                bool json, const std::string& page) {
  const Result<std::vector<LinearFile>> files = linear_files(folder);
  if (!files) return tl::unexpected(files.error());
  Progress progress;
  const std::atomic<bool>& interrupted = catch_interrupts();
  const Result<LinearReport> report = evaluate_linear(
      *files, options.methods, options.search, options.threads,
      [&](double share, std::uint64_t queries) {
        progress.show(share, "linear queries", queries, "queries");
      },
      &interrupted);
  progress.clear();
  if (!report) return tl::unexpected(report.error());
  if (json) {
    for (const LinearGroup& group : report->groups) print_json(linear_group_json(group));
    for (const Imported& query : report->notable) print_json(notable_json(query));
  } else {
    print_table(linear_table(report->groups));
    print_refusals(report->groups);
    print_out("\n");
    std::uint64_t wrong = 0;
    for (const Imported& query : report->notable) {
      wrong += query.label_is_wrong();
      print_out(notable_text(query));
    }
    print_out(fmt::format(
        "{} queries; {} of {} labels are wrong; {} values of {} queries are no "
        "doubles and were rounded\n",
        report->queries, wrong, report->labels, report->rounded_values, report->rounded_queries));
  }
  if (!page.empty()) {
    if (auto done = write_linear_page(folder, *report, options, page); !done) {
      return tl::unexpected(done.error());
    }
  }
  return interrupted ? interrupted_exit_code() : kDone;
}

}  // namespace ccdfuzz
