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

}  // namespace ccdfuzz
