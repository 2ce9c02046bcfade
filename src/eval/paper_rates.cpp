#include "eval/paper_rates.hpp"

#include <array>

namespace ccdfuzz {

namespace {

struct Row {
  std::string_view contact;
  PaperRate trad_false_positives;
  /// One number for all variants of TDIBM: their columns agree in every class.
  PaperRate tdibm_false_positives;
  PaperRate trad_false_negatives;
  std::uint64_t tdibm, tdibm_h_16;  ///< false negatives, of as many as the false positives
};

constexpr std::array<Row, 6> kTable2 = {{
    {"FF", {13, 20}, {6, 6003}, {0, 20}, 0, 0},
    {"EF", {2, 1020}, {1, 1020}, {0, 1020}, 0, 0},
    {"EE", {7, 10}, {50, 1000}, {0, 10}, 135, 20},
    {"VF", {0, 1000}, {0, 1000}, {12, 1000}, 212, 22},
    {"VE", {363, 1000}, {223, 1000}, {73, 1000}, 452, 196},
    {"VV", {65, 1000}, {44, 1000}, {0, 1000}, 860, 658},
}};

struct GenerationTimes {
  std::string_view contact;
  double regular, grazing;  ///< seconds
};

constexpr std::array<GenerationTimes, 6> kTable4 = {{
    {"FF", 59.03, 215.23},
    {"EF", 26.88, 131.62},
    {"EE", 22.72, 1249.27},
    {"VF", 20.83, 46.63},
    {"VE", 20.81, 71.21},
    {"VV", 18.98, 24.30},
}};

}  // namespace

std::optional<PaperRates> paper_rates(std::string_view contact, const std::string& method) {
  for (const Row& row : kTable2) {
    if (row.contact != contact) continue;
    if (method == "trad") return PaperRates{row.trad_false_positives, row.trad_false_negatives};
    const std::uint64_t total = row.tdibm_false_positives.total;
    const auto with_false_negatives = [&](std::uint64_t count) {
      return PaperRates{row.tdibm_false_positives, {count, total}};
    };
    if (method == "tdibm") return with_false_negatives(row.tdibm);
    if (method == "tdibm-h:1e-16") return with_false_negatives(row.tdibm_h_16);
    if (method == "tdibm-h:1e-12" || method == "tdibm-h:1e-8" || method == "tdibm-e") {
      return with_false_negatives(0);
    }
  }
  return std::nullopt;
}

std::optional<double> paper_generation_seconds(std::string_view contact, std::string_view kind) {
  const bool regular = kind == "RP" || kind == "RN" || kind == "RP+RN";
  const bool grazing = kind == "NHP" || kind == "NMN" || kind == "NHP+NMN";
  for (const GenerationTimes& row : kTable4) {
    if (row.contact != contact) continue;
    if (regular) return row.regular;
    if (grazing) return row.grazing;
  }
  return std::nullopt;
}

}  // namespace ccdfuzz
