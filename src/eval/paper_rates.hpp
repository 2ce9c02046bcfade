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

/// The paper's numbers of a method on the cases of a contact class.
struct PaperResult {
  double seconds = 0;  ///< mean
  PaperRate false_positives;
  /// Absent for the traditional method on face-face near-hits: none ended in time.
  std::optional<PaperRate> false_negatives;
};

/// kinds: kRegularKinds or kGrazingKinds, the halves of Table 2, "all": Table 1, or kLinearKind:
/// Table 3.
/// nullopt where the paper has no row for the class or no column for the method.
std::optional<PaperResult> paper_result(std::string_view contact, std::string_view kinds,
                                        const std::string& method);

/// Table 4: the time that an accepted case of a class took, with its share of what was discarded.
/// kind: one of those, or a half of Table 2. nullopt for any other.
std::optional<double> paper_generation_seconds(std::string_view contact, const std::string& kind);

}  // namespace ccdfuzz
