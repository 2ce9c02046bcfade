#pragma once

#include <cstdint>
#include <optional>

#include "case/certificate.hpp"
#include "case/query.hpp"

namespace ccdfuzz {

/// Builds certificate T (certify/checker/miss_tree.hpp): a tree of separating axes for the closed
/// [0, until]. Nothing if it needs more than max_nodes nodes, or too many bytes, as it does where
/// the patches touch. Depth first. A leaf is written only where the axis, rounded to a few bits,
/// separates by more than tdibm-c's error bound at both ends of its window. So the exact checker
/// accepts it. Throws OutOfTime (base/time_limit.hpp). Requires a valid query, 0 ≤ until ≤ the
/// largest double.
std::optional<MissTree> build_miss_tree(const Query& query, const Rational& until,
                                        std::uint64_t max_nodes);

}  // namespace ccdfuzz
