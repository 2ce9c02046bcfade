#include "eval/paper_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ccdfuzz {

namespace {

std::string rate_text(const PaperRate& rate) {
  if (rate.total == 0) return "-";
  return fmt::format("{}/{} = {:.1f} %", rate.count, rate.total,
                     100.0 * static_cast<double>(rate.count) / static_cast<double>(rate.total));
}

PaperRate missed_of(const Tally& tally) {
  return {tally.count(Outcome::kMissed), tally.positives};
}

PaperRate false_positives_of(const Tally& tally) {
  return {tally.count(Outcome::kFalsePositive), tally.negatives};
}

std::vector<PaperComparison> compare(const std::vector<EvaluatedGroup>& groups,
                                     const std::string& kinds) {
  std::vector<PaperComparison> rows;
  for (EvaluatedGroup& group :
       at_contact(groups, kinds == "all" ? std::optional<std::string>() : kinds)) {
    if (group.tally.n == 0) continue;  // all refused
    const auto paper = paper_result(group.contact, kinds, group.method);
    rows.push_back({kinds, std::move(group), paper});
  }
  return rows;
}

bool has_kinds(const std::vector<EvaluatedGroup>& groups, const std::string& kinds) {
  return std::ranges::any_of(groups, [&](const EvaluatedGroup& g) { return g.kinds == kinds; });
}

}  // namespace

std::vector<PaperComparison> compare_with_table_1(const std::vector<EvaluatedGroup>& groups) {
  const bool whole = has_kinds(groups, "RP+RN") && has_kinds(groups, "NHP+NMN");
  return whole ? compare(groups, "all") : std::vector<PaperComparison>();
}

std::vector<PaperComparison> compare_with_table_2(const std::vector<EvaluatedGroup>& groups) {
  std::vector<PaperComparison> rows = compare(groups, "RP+RN");
  std::ranges::move(compare(groups, "NHP+NMN"), std::back_inserter(rows));
  return rows;
}

Table paper_table(const std::vector<PaperComparison>& rows) {
  Table table({{"class", Align::kLeft},
               {"kinds", Align::kLeft},
               {"method", Align::kLeft},
               {"mean"},
               {"paper's"},
               {"FN missed"},
               {"paper's FN"},
               {"FP"},
               {"paper's FP"}});
  const PaperComparison* previous = nullptr;
  for (const PaperComparison& row : rows) {
    const EvaluatedGroup& group = row.group;
    if (previous && (previous->group.contact != group.contact || previous->kinds != row.kinds)) {
      table.start_group();
    }
    previous = &row;
    const auto of_paper = [&](const std::optional<std::string>& text) -> TableCell {
      return text ? TableCell{*text} : TableCell{"-", Emphasis::kFaint};
    };
    const std::optional<PaperResult>& paper = row.paper;
    const bool has_fn = paper && paper->false_negatives;
    const PaperRate missed = missed_of(group.tally);
    table.add_row(
        {{group.contact},
         {row.kinds},
         {group.method},
         {duration_text(group.tally.mean_seconds())},
         of_paper(paper ? std::optional(duration_text(paper->seconds)) : std::nullopt),
         {rate_text(missed), missed.count > 0 ? Emphasis::kBad : Emphasis::kPlain},
         of_paper(has_fn ? std::optional(rate_text(*paper->false_negatives)) : std::nullopt),
         {rate_text(false_positives_of(group.tally))},
         of_paper(paper ? std::optional(rate_text(paper->false_positives)) : std::nullopt)});
  }
  return table;
}

}  // namespace ccdfuzz
