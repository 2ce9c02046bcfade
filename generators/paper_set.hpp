#pragma once

#include <vector>

#include "generators/generate.hpp"

namespace ccdfuzz {

/// One construction of the set. kRP stands for both regular kinds: an RN case has the patches of
/// the RP case of its index and ends before the contact.
struct PaperItem {
  ContactClass contact = ContactClass::kFF;
  CaseKind kind = CaseKind::kRP;  ///< kRP, kNHP or kNMN
  std::uint64_t index = 0;
};

/// All constructions in the order of the set: class by class, in it the regular ones, near-hits and
/// near-misses. one_in ≥ 1: only that part of each count, rounded up.
std::vector<PaperItem> paper_items(std::uint64_t one_in = 1);

struct PaperCases {
  /// RP and RN, or the one. NMN: with a miss tree for [0, t_max] that the checker has accepted,
  /// unless there is none of at most kPaperTreeNodes nodes.
  std::vector<Case> cases;
  DiscardCounts discards;
};

/// Four times what the oracle takes by default: 250,000 are too few for 1 of the 1,100 near-misses
/// of seed 1.
inline constexpr std::uint64_t kPaperTreeNodes = 1'000'000;

/// The cases of a construction, as generate makes them with this seed and Construction::kPaper.
PaperCases make_paper_cases(const PaperItem& item, std::uint64_t seed);

}  // namespace ccdfuzz
