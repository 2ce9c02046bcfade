#pragma once

#include "generators/attempts.hpp"

namespace ccdfuzz {

/// True iff the options ask for patches of any shapes, which are made here; else for quadratic
/// triangles as generate() makes them.
bool is_shaped(const GeneratorOptions& options);

/// Errors: options of shaped cases, of a class and kind that is made, which have other faults;
/// naming the option and its value.
Result<void> validate_shaped(const GeneratorOptions& options);

/// The shapes that are asked for, or random ones that fit.
std::array<Shape, 2> shapes_of(const GeneratorOptions& options, Draw& draw);

/// A positive of this family, of shapes that fit the options.
Attempted plain_case(Family family, const GeneratorOptions& options, Draw& draw);

/// A positive. If RN is asked for, the negative with the same patches that ends eps_T before the
/// contact, which must be proven clear until then.
Attempted as_asked(Case positive, const GeneratorOptions& options);

}  // namespace ccdfuzz
