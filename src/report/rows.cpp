#include "report/rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/enum_names.hpp"
#include "case/horizons.hpp"
#include "case/taxonomy.hpp"
#include "eval/curvature.hpp"

namespace ccdfuzz {

namespace {

/// Cases of each class and kind to show where no method fails.
constexpr int kSamplesOfEach = 4;

std::size_t rank_of_class(const std::string& contact) {
  const auto known = enum_named<ContactClass>(contact);
  return known ? static_cast<std::size_t>(*known) : kContactClasses.size();
}

}  // namespace

std::size_t ReportRows::place_of(const std::string& method) {
  const auto at = std::ranges::find(methods_, method);
  const auto place = static_cast<std::size_t>(at - methods_.begin());
  if (at == methods_.end()) methods_.push_back(method);
  return place;
}

void ReportRows::add(const EvaluatedCase& evaluated, const Case& known, double precision) {
  add_curvatures(known);
  std::optional<ReportedCase> open;
  for (const GivenAnswer& given : evaluated.answers) {
    ReportGroup& group = groups_[{rank_of_class(evaluated.contact), evaluated.contact,
                                  evaluated.kind, given.factor, place_of(given.method)}];
    group.contact = evaluated.contact;
    group.kind = evaluated.kind;
    group.factor = given.factor;
    group.method = given.method;
    Answer answer;
    answer.pops = given.pops;
    answer.seconds = given.seconds;
    group.tally.add(answer, given.outcome, evaluated.collides);
    if (given.outcome != Outcome::kNotAsked) group.timings.add(given.seconds);

    if (!open) {
      open.emplace();
      open->id = evaluated.id;
      open->precision = precision;
    }
    open->answers.push_back({given.method, given.outcome, given.toi});
    if (&given != &evaluated.answers.back() && (&given)[1].factor == given.factor) continue;
    keep(*std::move(open), known, given.factor);
    open.reset();
  }
}

void ReportRows::add_curvatures(const Case& known) {
  if (!known.truth.collides.value_or(false)) return;
  const auto curvatures = curvature_at_contact(known);
  if (!curvatures) return;
  for (const std::optional<Curvature>& one : *curvatures) {
    if (one) curvatures_.push_back(one->rms());
  }
}

void ReportRows::keep(ReportedCase reported, const Case& known,
                      const std::optional<double>& factor) {
  const bool failed = has_failure(reported);
  if (!failed && ++sampled_[known.origin.contact + known.origin.kind] > kSamplesOfEach) return;
  if (factor && *factor != 1) reported.id += fmt::format(" ×{}", *factor);
  const std::optional<Case> at = factor ? at_horizon(known, *factor) : std::nullopt;
  reported.value = at ? *at : known;
  (failed ? failed_ : samples_).push_back(std::move(reported));
}

void ReportRows::finish(ReportPage& report, const std::vector<GenerationCost>& costs) {
  for (auto& [key, group] : groups_) report.groups.push_back(std::move(group));
  if (!costs.empty()) {
    report.tables.push_back(
        report_table("table-4", "Table 4. How the cases were made", generation_table(costs)));
  }
  report.curvatures = std::move(curvatures_);
  report.cases = std::move(failed_.empty() ? samples_ : failed_);
  keep_most_telling(report);
}

}  // namespace ccdfuzz
