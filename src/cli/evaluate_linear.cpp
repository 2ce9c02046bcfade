#include "cli/evaluate_linear.hpp"

#include <fmt/format.h>

#include "base/fields.hpp"
#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/refusals.hpp"
#include "cli/terminal.hpp"
#include "eval/linear_table.hpp"
#include "report/report.hpp"

namespace ccdfuzz {

namespace {

/// A row of the linear queries.
struct LinearRow {
  const Row& row;

  static void fields(auto& archive, auto& linear) {
    const Row& row = linear.row;
    archive("queries", row.key.contact);
    archive("method", row.key.method);
    Tally::fields(archive, row.tally);
    archive("mean_seconds", row.tally.seconds.mean());
    archive("median_seconds", row.tally.seconds.median());
    archive("p99_seconds", row.tally.seconds.p99());
  }
};

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
  page.rows = report.rows;
  page.tables.push_back(
      report_table("table-3", "Table 3. Linear queries", linear_table(report.rows)));
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
  if (interrupted) {
    print_err(fmt::format("ccdfuzz: interrupted after {} queries; the table is of these alone\n",
                          report->queries));
  }
  if (json) {
    for (const Row& row : report->rows) print_out(to_json(LinearRow{row}) + "\n");
    for (const Imported& query : report->notable) print_out(to_json(query) + "\n");
  } else {
    print_table(linear_table(report->rows));
    print_refusals(report->rows);
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
