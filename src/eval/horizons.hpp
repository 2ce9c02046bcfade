#pragma once

#include <array>
#include <optional>
#include <vector>

#include "case/checked_case.hpp"

namespace ccdfuzz {

/// How far past a known contact queries look, as multiples of its time: just at it, just past it
/// and well past it. A query that ends at the contact hides every toi that is late.
inline constexpr std::array kHorizonFactors = {1.0, 1 + 0x1p-30, 1.5, 2.0};

/// Another t_max to ask the case up to (with_t_max): factor · t*, rounded up, t* the time by which
/// a contact is known; factor ≥ 1. Where t* = 0, (factor − 1) · t_max. nullopt if none is known, or
/// the product is no finite double, or past 1 of patches with ends or that turn.
std::optional<double> horizon_of(const Case& known, double factor);

/// How a case is put to methods. A positive one of patches is asked at t* and past it
/// (kHorizonFactors), so that late answers show. A negative one, one without a witness, and one of
/// bodies are asked as they stand.
std::vector<CheckedCase> forms_of(const CheckedCase& known);

}  // namespace ccdfuzz
