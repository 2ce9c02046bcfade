#include "report/rows.hpp"

#include <fmt/format.h>

#include <utility>

#include "eval/curvature.hpp"
#include "eval/horizons.hpp"
#include "eval/tables.hpp"

namespace ccdfuzz {

namespace {

/// Cases of each class and kind to show where no method fails.
constexpr int kSamplesOfEach = 4;

}  // namespace

void ReportRows::add(const EvaluatedCase& evaluated, const Case& known, double precision) {
  add_curvatures(known);
  const auto end = evaluated.answers.end();
  for (auto from = evaluated.answers.begin(), to = from; from != end; from = to) {
    to = std::find_if(from, end, [&](const auto& given) { return given.factor != from->factor; });
    keep({.id = evaluated.id, .answers = {from, to}, .precision = precision}, known, from->factor);
  }
}

void ReportRows::add_curvatures(const Case& known) {
  const std::optional<Witness>& witness = known.truth.witness;
  if (known.truth.collides != true || !witness) return;
  for (size_t s = 0; s < 2; ++s) {
    const auto one = rms_curvature(known.query.patches[s], witness->uv[s], witness->t);
    if (one) curvatures_.add(*one);
  }
}

void ReportRows::keep(ReportedCase reported, const Case& known,
                      const std::optional<double>& factor) {
  const bool failed = reported.has_failure();
  if (!failed && ++sampled_[known.origin.contact + known.origin.kind] > kSamplesOfEach) return;
  if (factor && *factor != 1) reported.id += fmt::format(" ×{}", *factor);
  const std::optional<double> t_max = factor ? horizon_of(known, *factor) : std::nullopt;
  reported.value = t_max ? with_t_max(known, *t_max) : known;
  (failed ? failed_ : samples_).push_back(std::move(reported));
}

void ReportRows::finish(ReportPage& report, const Rows& rows,
                        const std::vector<GenerationCost>& costs) {
  report.rows = rows.in_order();
  if (Table linear = paper_table_3(rows); linear.row_count() > 0) {
    report.tables.push_back({"table-3", "Table 3. Linear queries, beside the paper's",
                             std::move(linear), kLinearNote + column_notes(by_methods(rows))});
  }
  if (!costs.empty()) {
    report.tables.push_back(
        {"table-4", "Table 4. How the cases were made", generation_table(costs)});
  }
  report.curvatures = std::move(curvatures_);
  report.cases = std::move(failed_.empty() ? samples_ : failed_);
  keep_most_telling(report);
}

}  // namespace ccdfuzz
