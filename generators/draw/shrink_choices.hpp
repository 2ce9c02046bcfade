#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// Simpler choices first: the shorter sequence, or of equal lengths the one that is less at the
/// first difference. What is drawn of simpler choices has fewer parts, fewer control points that
/// are not zero, fewer bits and smaller exponents.
bool simpler(const ChoiceNumbers& x, const ChoiceNumbers& y);

/// All the simpler sequences that are tried for one: parts left out, numbers made 0, halved,
/// stripped of low bits and lessened by little. In the order in which they are worth trying.
std::vector<ChoiceNumbers> simpler_choices(const ChoiceNumbers& numbers);

/// The least that could be found with at most `tries` calls of `keeps`, which says whether a
/// sequence still shows what `numbers` shows. Deterministic.
ChoiceNumbers shrunk(ChoiceNumbers numbers, std::uint64_t tries,
                     const std::function<bool(const ChoiceNumbers&)>& keeps);

}  // namespace ccdfuzz
