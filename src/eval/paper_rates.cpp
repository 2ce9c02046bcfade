#include "eval/paper_rates.hpp"

#include <algorithm>
#include <array>

#include "eval/rows.hpp"
#include "files/query_csv.hpp"

namespace ccdfuzz {

namespace {

/// The paper's columns.
constexpr std::array<std::string_view, 6> kPaperMethods = {
    "trad", "tdibm", "tdibm-h:1e-16", "tdibm-h:1e-12", "tdibm-h:1e-8", "tdibm-e"};

/// The classes of a table, in its order.
constexpr std::array<std::string_view, 6> kClasses = {"FF", "EF", "EE", "VF", "VE", "VV"};
constexpr std::array<std::string_view, 2> kClassesOfLinear = {"EE", "VF"};

using Milliseconds = std::array<double, 6>;

/// Those but the traditional method's are out of `total`.
struct PaperCounts {
  std::uint64_t total, trad_total;
  std::array<std::uint64_t, 6> false_positives, false_negatives;
};

// Table 2. For false positives it prints one column of TDIBM-H less than for times. Where 1e-12 and
// 1e-8 differ, Table 1 minus the regular half tells which it is.
constexpr std::array<Milliseconds, 6> kRegularTimes = {{
    {2.23e5, 338.09, 390.50, 377.61, 624.43, 382.02},
    {293.11, 56.06, 59.16, 57.52, 80.02, 57.26},
    {9887.50, 12.70, 12.39, 13.10, 31.59, 13.27},
    {13.91, 12.48, 13.17, 12.95, 36.35, 15.37},
    {732.19, 27.28, 30.12, 32.55, 72.93, 36.57},
    {2.94, 2.68, 3.12, 4.02, 9.50, 4.69},
}};
constexpr std::array<PaperCounts, 6> kRegularCounts = {{
    {6003, 20, {13, 6, 6, 6, 6, 6}, {}},
    {1020, 1020, {2, 1, 1, 1, 1, 1}, {}},
    {1000, 10, {7, 50, 50, 50, 50, 50}, {0, 135, 20, 0, 0, 0}},
    {1000, 1000, {0, 0, 0, 0, 0, 0}, {12, 212, 22, 0, 0, 0}},
    {1000, 1000, {363, 223, 223, 223, 223, 223}, {73, 452, 196, 0, 0, 0}},
    {1000, 1000, {65, 44, 44, 44, 44, 44}, {0, 860, 658, 0, 0, 0}},
}};
constexpr std::array<Milliseconds, 6> kGrazingTimes = {{
    {8303.91, 121.52, 125.14, 136.12, 279.07, 140.27},
    {426.15, 92.37, 93.76, 99.38, 143.36, 112.65},
    {23.52, 58.20, 57.37, 60.80, 87.03, 68.31},
    {451.47, 28.27, 32.69, 30.88, 42.47, 29.78},
    {16.02, 11.85, 12.23, 11.94, 19.07, 12.14},
    {0.71, 1.26, 1.37, 1.52, 1.85, 1.29},
}};
constexpr std::array<PaperCounts, 6> kGrazingCounts = {{
    {600, 20, {0, 169, 169, 169, 169, 169}, {}},
    {100, 100, {7, 6, 6, 6, 6, 6}, {}},
    {100, 100, {89, 71, 71, 71, 71, 71}, {}},
    {100, 100, {1, 0, 0, 0, 0, 0}, {}},
    {100, 100, {95, 87, 87, 89, 89, 87}, {}},
    {100, 100, {67, 12, 12, 12, 14, 12}, {}},
}};

// Table 1. Its counts are the sums of Table 2's.
constexpr std::array<Milliseconds, 6> kTimesOfAll = {{
    {1.51e5, 327.73, 377.87, 366.12, 607.99, 370.51},
    {299.33, 57.76, 60.78, 59.48, 82.98, 59.85},
    {1667.52, 14.87, 14.53, 15.37, 34.22, 15.89},
    {34.75, 13.23, 14.10, 13.80, 36.63, 16.06},
    {698.09, 26.55, 29.53, 31.57, 70.36, 35.51},
    {2.83, 2.61, 3.04, 3.90, 9.14, 4.53},
}};

// Table 3. Times of 0: the paper has no such column.
constexpr std::array<Milliseconds, 2> kLinearTimes = {{
    {1.084, 2.56e-3, 0, 3.66e-3, 0, 0.21},
    {6.13e-3, 5.22e-3, 0, 0.70e-3, 0, 1.72e-2},
}};
constexpr std::array<PaperCounts, 2> kLinearCounts = {{
    {34129, 34129, {300, 33, 0, 117, 0, 249}, {0, 338, 0, 0, 0, 0}},
    {21209, 21209, {94, 9, 0, 59, 0, 107}, {0, 228, 0, 0, 0, 0}},
}};

// Table 4, in seconds: of the regular half and of the grazing one.
constexpr std::array<std::array<double, 2>, 6> kGenerationTimes = {{
    {59.03, 215.23},
    {26.88, 131.62},
    {22.72, 1249.27},
    {20.83, 46.63},
    {20.81, 71.21},
    {18.98, 24.30},
}};

template <size_t kCount>
size_t place_of(std::string_view name, const std::array<std::string_view, kCount>& in) {
  return static_cast<size_t>(std::ranges::find(in, name) - in.begin());
}

PaperResult result_of(const Milliseconds& times, const PaperCounts& counts, size_t method) {
  const std::uint64_t total = method == 0 ? counts.trad_total : counts.total;
  PaperResult result{times[method] * 1e-3,
                     {counts.false_positives[method], total},
                     PaperRate{counts.false_negatives[method], total}};
  if (&counts == &kGrazingCounts[0] && method == 0) result.false_negatives.reset();
  return result;
}

PaperRate sum(const PaperRate& a, const PaperRate& b) {
  return {a.count + b.count, a.total + b.total};
}

}  // namespace

std::optional<PaperResult> paper_result(std::string_view contact, std::string_view kinds,
                                        const std::string& method) {
  const size_t column = place_of(method, kPaperMethods);
  if (column == kPaperMethods.size()) return std::nullopt;
  if (kinds == kLinearKind) {
    const size_t i = place_of(contact, kClassesOfLinear);
    if (i == kClassesOfLinear.size() || kLinearTimes[i][column] == 0) return std::nullopt;
    return result_of(kLinearTimes[i], kLinearCounts[i], column);
  }
  const size_t i = place_of(contact, kClasses);
  if (i == kClasses.size()) return std::nullopt;
  const PaperResult regular = result_of(kRegularTimes[i], kRegularCounts[i], column);
  const PaperResult grazing = result_of(kGrazingTimes[i], kGrazingCounts[i], column);
  if (kinds == kRegularKinds) return regular;
  if (kinds == kGrazingKinds) return grazing;
  if (kinds != "all") return std::nullopt;
  PaperResult all = regular;
  all.seconds = kTimesOfAll[i][column] * 1e-3;
  all.false_positives = sum(regular.false_positives, grazing.false_positives);
  if (grazing.false_negatives) {
    all.false_negatives = sum(*regular.false_negatives, *grazing.false_negatives);
  }
  return all;
}

std::optional<double> paper_generation_seconds(std::string_view contact, const std::string& kind) {
  const std::string kinds = kinds_of(kind);
  const size_t i = place_of(contact, kClasses);
  if (i == kClasses.size()) return std::nullopt;
  if (kinds == kRegularKinds) return kGenerationTimes[i][0];
  if (kinds == kGrazingKinds) return kGenerationTimes[i][1];
  return std::nullopt;
}

}  // namespace ccdfuzz
