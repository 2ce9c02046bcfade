#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ccdfuzz {

/// A count out of a total, as printed in the paper.
struct PaperRate {
  std::uint64_t count = 0;
  std::uint64_t total = 0;
};

/// What Table 2 reports of a method on the regular cases (RP+RN) of a contact class.
struct PaperRates {
  PaperRate false_positives;
  PaperRate false_negatives;
};

/// nullopt where the paper has no row for the class or no column for the method.
std::optional<PaperRates> paper_rates(std::string_view contact, const std::string& method);

/// Table 4: the time that an accepted case of a class took, with its share of what was discarded.
/// kind: one or more kinds joined by '+', all regular or all grazing. nullopt for any other.
std::optional<double> paper_generation_seconds(std::string_view contact, std::string_view kind);

}  // namespace ccdfuzz
