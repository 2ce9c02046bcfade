#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "method/method.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// Those that are proven to miss nothing; without the oracle, which judges them.
const std::vector<std::string>& miss_nothing();

/// A query with what the oracle proves of it within budgets that take milliseconds. max_pops: of
/// each search; a tree may have ten times as many nodes.
/// Throws Refuted where the checker refuses a certificate, with the case.
Case decide_briefly(const Query& query, std::uint64_t max_pops);

/// How the method does on a case with a truth.
Outcome outcome_on(Method& method, const Case& known, const SearchOptions& options);

/// Throws Refuted, with the case, where the method misses a contact that the case has proven, or is
/// late for it.
void claim_not_contradicted(const std::string& name, Method& method, const Case& known,
                            const SearchOptions& options);

/// What takes microseconds, and is no less right: every toi is a lower bound.
inline constexpr SearchOptions kRefutationSearch = {0x1p-6, 40, 16 << 20};
/// As little of the oracle (decide_briefly).
inline constexpr std::uint64_t kRefutationPops = 24;

/// The claims of all that miss nothing, on one query: the oracle's, the checker's, tdibm-c's and
/// tdibm-rational's. Where no contact is proven, those of the former two alone. Throws Refuted,
/// with the case.
void claim_all_agree(const Query& query, std::uint64_t max_pops, const SearchOptions& search);

}  // namespace ccdfuzz
