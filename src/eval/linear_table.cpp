#include "eval/linear_table.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "base/cpu_time.hpp"
#include "base/in_order.hpp"
#include "certify/checker/check_case.hpp"
#include "eval/race.hpp"
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

std::string paper_cell(const LinearGroup& group, const auto& text) {
  const auto row = std::ranges::find_if(kTable3, [&](const LinearPaperRow& r) {
    return r.layout == group.layout && r.method == group.method;
  });
  return row == kTable3.end() ? "" : text(*row);
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
  for (const CsvLayout layout : {CsvLayout::kEdgeEdge, CsvLayout::kVertexFace}) {
    for (const std::string& method : methods) report.groups.push_back({layout, method, {}, {}});
  }
  tbb::enumerable_thread_specific<MethodSet> method_sets;
  size_t done_files = 0;
  for (const LinearFile& file : files) {
    const Result<std::vector<CsvQuery>> queries = read_csv(file.path, file.layout);
    if (!queries) return tl::unexpected(queries.error());
    Result<void> failed;
    const size_t first_group = file.layout == CsvLayout::kEdgeEdge ? 0 : methods.size();
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
            LinearGroup& group = report.groups[first_group + m];
            TimedAnswer& timed = result->answers[m];
            timed.judged.answer.seconds = timed.seconds;
            group.tally.add(timed.judged.answer, timed.judged.outcome, query.value.truth.collides);
            if (timed.judged.outcome != Outcome::kNotAsked) group.timings.add(timed.seconds);
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
  std::erase_if(report.groups, [](const LinearGroup& group) {
    return group.tally.n + group.tally.not_asked() == 0;
  });
  return report;
}

Table linear_table(const std::vector<LinearGroup>& groups) {
  const bool refusals = std::ranges::any_of(
      groups, [](const LinearGroup& group) { return group.tally.not_asked() > 0; });
  std::vector<Table::Column> columns = {{"queries", Align::kLeft},
                                        {"method", Align::kLeft},
                                        {"n"},
                                        {"contacts"},
                                        {"mean"},
                                        {"median"},
                                        {"p99"},
                                        {"FP"},
                                        {"FN missed"},
                                        {"FN late"},
                                        {"undecided"}};
  if (refusals) columns.push_back({"not asked"});
  for (const char* title : {"paper: mean", "FP", "FN"}) columns.push_back({title});
  Table table(columns);
  const LinearGroup* last = nullptr;
  for (const LinearGroup& group : groups) {
    if (last && last->layout != group.layout) table.start_group();
    last = &group;
    const Tally& tally = group.tally;
    const int total = group.layout == CsvLayout::kEdgeEdge ? kTable3EdgeEdge : kTable3VertexFace;
    const auto count = [&](Outcome outcome) { return fmt::format("{}", tally.count(outcome)); };
    const auto bad = [&](Outcome outcome) {
      return tally.count(outcome) > 0 ? Emphasis::kBad : Emphasis::kPlain;
    };
    const auto of_total = [total](int n) { return fmt::format("{}/{}", n, total); };
    const auto if_asked = [&](std::string text) { return tally.n > 0 ? std::move(text) : "-"; };
    std::vector<TableCell> cells = {
        {name_of(group.layout)},
        {group.method},
        {fmt::format("{}", tally.n)},
        {fmt::format("{}", tally.positives)},
        {if_asked(duration_text(tally.mean_seconds()))},
        {if_asked(duration_text(group.timings.median()))},
        {if_asked(duration_text(group.timings.p99()))},
        {count(Outcome::kFalsePositive)},
        {count(Outcome::kMissed), bad(Outcome::kMissed)},
        {count(Outcome::kLate), bad(Outcome::kLate)},
        {fmt::format("{}", tally.count(Outcome::kUndecided) + tally.count(Outcome::kError))}};
    if (refusals) cells.push_back({fmt::format("{}", tally.not_asked())});
    cells.insert(
        cells.end(),
        {{paper_cell(group, [](const auto& r) { return duration_text(r.milliseconds * 1e-3); })},
         {paper_cell(group, [&](const auto& r) { return of_total(r.false_positives); })},
         {paper_cell(group, [&](const auto& r) { return of_total(r.false_negatives); })}});
    table.add_row(std::move(cells));
  }
  return table;
}

}  // namespace ccdfuzz
