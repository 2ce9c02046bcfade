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
tl::expected<Case, Discard> plain_case(Family family, const GeneratorOptions& options,
                                       const Dyadic& eps_t, Draw& draw);

/// Turns a positive case with a clearance into the negative one that ends before the contact.
/// Returns false if it has none, or the time is no double.
bool end_before_contact(Case& value, const Dyadic& until);

}  // namespace ccdfuzz
