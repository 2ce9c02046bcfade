#include "eval/linear_table.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "base/cpu_time.hpp"
#include "base/in_order.hpp"
#include "certify/checker/check_case.hpp"
#include "eval/columns.hpp"
#include "eval/race.hpp"
#include "eval/row_columns.hpp"
#include "method/ask.hpp"

namespace ccdfuzz {

namespace {

namespace fs = std::filesystem;

/// Table 3: mean milliseconds and false positives; false negatives but for tdibm are none.
struct LinearPaperRow {
  CsvLayout layout;
  std::string_view method;
  double milliseconds;
  int false_positives, false_negatives;
};
constexpr std::array<LinearPaperRow, 8> kTable3 = {{
    {CsvLayout::kEdgeEdge, "trad", 1.084, 300, 0},
    {CsvLayout::kEdgeEdge, "tdibm", 2.56e-3, 33, 338},
    {CsvLayout::kEdgeEdge, "tdibm-h:1e-12", 3.66e-3, 117, 0},
    {CsvLayout::kEdgeEdge, "tdibm-e", 0.21, 249, 0},
    {CsvLayout::kVertexFace, "trad", 6.13e-3, 94, 0},
    {CsvLayout::kVertexFace, "tdibm", 5.22e-3, 9, 228},
    {CsvLayout::kVertexFace, "tdibm-h:1e-12", 0.70e-3, 59, 0},
    {CsvLayout::kVertexFace, "tdibm-e", 1.72e-2, 107, 0},
}};
constexpr int kTable3EdgeEdge = 34129, kTable3VertexFace = 21209;

struct TimedAnswer {
  Judged judged;
  double seconds = 0;
};

TimedAnswer ask_timed(Method& method, const CheckedCase& known, const SearchOptions& search) {
  TimedAnswer best{{}, std::numeric_limits<double>::infinity()};
  for (int i = 0; i < Race::kRepeats && !(i > 0 && best.seconds > Race::kLong); ++i) {
    const double start = thread_cpu_seconds();
    best.judged = ask(method, known, search);
    const double own = thread_cpu_seconds() - start;
    best.seconds =
        std::min(best.seconds, method.runs_elsewhere() ? best.judged.answer.seconds : own);
  }
  return best;
}

struct AnsweredQuery {
  Imported query;
  std::vector<TimedAnswer> answers;  ///< of the methods
};

/// Whom to list; where nothing is wrong, nobody.
bool is_notable(const Imported& query) {
  return query.label_is_wrong() || query.rounding_changed_the_truth();
}

Column<Row> paper_column(const char* title, std::string (*text)(const LinearPaperRow&)) {
  return {title, [text](const Row& row) {
            const auto paper = std::ranges::find_if(kTable3, [&](const LinearPaperRow& r) {
              return name_of(r.layout) == row.key.contact && r.method == row.key.method;
            });
            return TableCell{paper == kTable3.end() ? "" : text(*paper)};
          }};
}

std::string of_total(const LinearPaperRow& row, int n) {
  const int total = row.layout == CsvLayout::kEdgeEdge ? kTable3EdgeEdge : kTable3VertexFace;
  return fmt::format("{}/{}", n, total);
}

Column<Row> count_column(const char* title, std::uint64_t (*count)(const Tally&), bool is_bad) {
  return {title, [=](const Row& row) {
            const std::uint64_t n = count(row.tally);
            const bool shown_bad = is_bad && n > 0;
            return TableCell{fmt::format("{}", n), shown_bad ? Emphasis::kBad : Emphasis::kPlain};
          }};
}

}  // namespace

Result<std::vector<LinearFile>> linear_files(const std::string& folder) {
  std::error_code error;
  fs::recursive_directory_iterator entries(folder, error);
  if (error) return input_error(folder, "cannot be read: " + error.message());
  std::vector<LinearFile> files;
  for (const fs::directory_entry& entry : entries) {
    const std::string path = entry.path().string();
    const auto layout = csv_layout_of_path(path);
    if (!entry.is_regular_file() || !path.ends_with(".csv")) continue;
    if (layout && *layout != CsvLayout::kCurved) files.push_back({path, *layout});
  }
  if (files.empty()) {
    return input_error(folder,
                       "holds no .csv that is edge-edge or vertex-face by its own name or that of "
                       "its folder");
  }
  std::ranges::sort(files, [](const LinearFile& x, const LinearFile& y) {
    return std::tie(x.layout, x.path) < std::tie(y.layout, y.path);
  });
  return files;
}

Result<LinearReport> evaluate_linear(
    const std::vector<LinearFile>& files, const std::vector<std::string>& methods,
    const SearchOptions& search, int threads,
    const std::function<void(double share, std::uint64_t queries)>& progress,
    const std::atomic<bool>* stop) {
  LinearReport report;
  Rows rows;
  tbb::enumerable_thread_specific<MethodSet> method_sets;
  size_t done_files = 0;
  for (const LinearFile& file : files) {
    const Result<std::vector<CsvQuery>> queries = read_csv(file.path, file.layout);
    if (!queries) return tl::unexpected(queries.error());
    Result<void> failed;
    run_in_order<Result<AnsweredQuery>>(
        queries->size(), threads,
        [&](size_t i) -> Result<AnsweredQuery> {
          Result<Imported> query = import_case((*queries)[i], true, i);
          if (!query) return tl::unexpected(query.error());
          Result<CheckedCase> known = check_case(query->value, "");
          if (!known) return tl::unexpected(known.error());
          AnsweredQuery answered{*std::move(query), {}};
          for (const std::string& method : methods) {
            answered.answers.push_back(ask_timed(method_sets.local()[method], *known, search));
          }
          return answered;
        },
        [&](Result<AnsweredQuery> result) {
          if (!result) {
            if (failed) failed = tl::unexpected(result.error());
            return;
          }
          Imported& query = result->query;
          for (size_t m = 0; m < methods.size(); ++m) {
            TimedAnswer& timed = result->answers[m];
            timed.judged.answer.seconds = timed.seconds;
            const RowKey key{std::string(name_of(file.layout)), "", std::nullopt, methods[m]};
            rows.add(key, timed.judged.answer, timed.judged.outcome, query.value.truth.collides);
          }
          ++report.queries;
          if (query.label) ++report.labels;
          report.rounded_values += query.rounded;
          if (query.rounded > 0) ++report.rounded_queries;
          if (is_notable(query)) report.notable.push_back(std::move(query));
        },
        stop);
    if (!failed) return tl::unexpected(failed.error());
    if (stop && *stop) break;
    progress(static_cast<double>(++done_files) / static_cast<double>(files.size()), report.queries);
  }
  report.rows = rows.in_order();
  return report;
}

Table linear_table(const std::vector<Row>& rows) {
  const auto time = [](const char* title, double (LogHistogram::*of)() const) {
    return measured_column<Row>(
        title, [of](const Row& row) { return duration_text((row.tally.seconds.*of)()); });
  };
  std::vector<Column<Row>> columns = {
      text_column<Row>("queries", [](const Row& row) { return row.key.contact; }),
      text_column<Row>("method", [](const Row& row) { return row.key.method; }),
      asked_column<Row>(),
      count_column(
          "contacts", [](const Tally& t) { return t.positives; }, false),
      time("mean", &LogHistogram::mean),
      time("median", &LogHistogram::median),
      time("p99", &LogHistogram::p99),
      count_column(
          "FP", [](const Tally& t) { return t.count(Outcome::kFalsePositive); }, false),
      count_column(
          "FN missed", [](const Tally& t) { return t.count(Outcome::kMissed); }, true),
      count_column(
          "FN late", [](const Tally& t) { return t.count(Outcome::kLate); }, true),
      count_column(
          "undecided",
          [](const Tally& t) { return t.count(Outcome::kUndecided) + t.count(Outcome::kError); },
          false)};
  add_refused_column(columns, rows);
  columns.insert(
      columns.end(),
      {paper_column("paper: mean",
                    [](const LinearPaperRow& r) { return duration_text(r.milliseconds * 1e-3); }),
       paper_column("FP", [](const auto& r) { return of_total(r, r.false_positives); }),
       paper_column("FN", [](const auto& r) { return of_total(r, r.false_negatives); })});
  return table_of(rows, columns, &are_beside);
}

}  // namespace ccdfuzz
