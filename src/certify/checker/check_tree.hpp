#pragma once

#include <cstdint>
#include <string_view>

#include "case/query.hpp"
#include "certify/checker/work.hpp"

namespace ccdfuzz {

/// Certificate T: checks in exact integers that the tree (miss_tree.hpp) covers both patches and
/// all of the closed [0, until]. Each leaf's axis must separate the control points of its two parts
/// at both ends of its window. Separation h(t) = max l·p − min l·q < 0 is convex in t, so it
/// holds in between; and parts lie in the hulls of their control points. Returns how many nodes
/// there are. A leaf may say instead that a part is outside of its patch's trim: no edge of a loop
/// meets it, and a vertex of it is outside. Requires a valid query, until ≥ 0. Errors: what is
/// wrong, naming node and field; more than most_work.
Result<std::uint64_t> check_tree(const Query& query, const Rational& until, std::string_view tree,
                                 std::uint64_t most_work = kMostWork);

}  // namespace ccdfuzz
