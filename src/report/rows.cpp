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

void ReportRows::add(const AnswerRecord& record, const NamedCase& source, double precision) {
  ReportGroup& group = groups_[{rank_of_class(record.contact), record.contact, record.kind,
                                record.factor, place_of(record.method)}];
  group.contact = record.contact;
  group.kind = record.kind;
  group.factor = record.factor;
  group.method = record.method;
  Answer answer;
  answer.pops = record.pops;
  answer.seconds = record.seconds;
  group.tally.add(answer, record.outcome, record.collides);
  if (record.outcome != Outcome::kNotAsked) group.timings.add(record.seconds);

  if (!open_ || open_->source != &source) add_curvatures(source.value);
  if (!open_ || open_->source != &source || open_->factor != record.factor) {
    if (open_) keep(std::move(*open_));
    open_ = Asked{{}, &source, record.factor};
    open_->reported.precision = precision;
  }
  open_->reported.answers.push_back({record.method, record.outcome, record.toi});
}

void ReportRows::add_curvatures(const Case& known) {
  if (!known.truth.collides.value_or(false)) return;
  const auto curvatures = curvature_at_contact(known);
  if (!curvatures) return;
  for (const std::optional<Curvature>& one : *curvatures) {
    if (one) curvatures_.push_back(one->rms());
  }
}

void ReportRows::keep(Asked asked) {
  const Case& known = asked.source->value;
  ReportedCase& reported = asked.reported;
  const bool failed = has_failure(reported);
  if (!failed && ++sampled_[known.origin.contact + known.origin.kind] > kSamplesOfEach) return;
  const bool moved = asked.factor && *asked.factor != 1;
  reported.id = asked.source->id;
  if (moved) reported.id += fmt::format(" ×{}", *asked.factor);
  const std::optional<Case> at = asked.factor ? at_horizon(known, *asked.factor) : std::nullopt;
  reported.value = at ? *at : known;
  (failed ? failed_ : samples_).push_back(std::move(reported));
}

void ReportRows::finish(ReportPage& report, const std::vector<GenerationCost>& costs) {
  if (open_) keep(std::move(*open_));
  open_.reset();
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
