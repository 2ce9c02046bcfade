#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/table.hpp"
#include "eval/groups.hpp"
#include "eval/paper_rates.hpp"

namespace ccdfuzz {

/// What was measured of a method on a class, beside what the paper reports.
struct PaperComparison {
  std::string kinds;  ///< "RP+RN", "NHP+NMN" or "all"
  EvaluatedGroup group;
  std::optional<PaperResult> paper;
};

/// The rows of Table 1: all kinds as one, where the answers are to both regular and grazing cases.
/// Of positives asked beyond the contact none counts.
std::vector<PaperComparison> compare_with_table_1(const std::vector<EvaluatedGroup>& groups);
/// The rows of Table 2: regular, then grazing cases.
std::vector<PaperComparison> compare_with_table_2(const std::vector<EvaluatedGroup>& groups);

/// Mean times, false positives and false negatives (missed: the paper's only sort) side by side.
Table paper_table(const std::vector<PaperComparison>& rows);

/// Everything that is known of each group, a row for each.
Table performance_table(const std::vector<EvaluatedGroup>& groups);
/// The same as a JSON object on one line.
std::string to_json(const EvaluatedGroup& group);

}  // namespace ccdfuzz
