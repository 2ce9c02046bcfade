#pragma once

#include <array>
#include <optional>

#include "case/case.hpp"
#include "generators/contact.hpp"
#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

/// Among what a case is drawn. All its numbers are multiplied by one power of two, from 2^lowest to
/// 2^highest; the patches are 2^3 across before that.
struct ContactRange {
  int lowest = -40;
  int highest = 40;
  int max_degree = 3;
  int coordinate_bits = 5;  ///< for the place of a control point, from the contact; 0 to 40
  /// Without, parameters are quarters, and times are 0, 1/2, 3/4 or 1. True: half of the patches
  /// touch at any parameters. These are multiples of 2^-27 on linear patches, and of more where
  /// degrees are higher or coordinates have many bits. Half of the contacts come up to 7·2^-43
  /// before or after.
  bool off_grid = false;
  /// True: these are multiples of 2^-10 and 2^-12, so that most numbers are floats (binary32).
  bool binary32 = false;
  /// The velocity that both share is below 2^(most_drift + 2).
  int most_drift = 12;
  /// True: half of the contacts are put into other coordinates (generators/elsewhere.hpp).
  bool elsewhere = false;
  /// Those of patches 1 and 2; by default any, of degrees up to max_degree.
  std::optional<std::array<Shape, 2>> shapes = {};
};

/// Errors: a range that has no contact, or hardly one, naming the field, its value and what it may
/// be. Scales are -1000 to 1000 in a valid one; draw_contact takes lower ones too.
Result<void> validate(const ContactRange& range);

/// Two moving patches of any of the four shapes that touch in an exact witness, at any feature, at
/// t* in [0, 1]. They are asked up to t*, a little past it, or up to 2. Most often each stays on
/// its own side of a plane through the contact and moves towards it. So the contact is the first
/// one. Control points without weight at the contact are sometimes twins of others up to a few
/// floats. `truth` holds the witness alone. Errors: the choices ask for numbers that no double
/// holds.
Result<Case> draw_contact(Draw& choices, const ContactRange& range);

/// The contact of the first case of the range that has a dyadic one. Requires a valid range.
Contact draw_witnessed(Draw& choices, const ContactRange& range);

/// A time that a query may end at: the double below `near` ≥ 0, one of a few next to it, or one
/// half or twice as large.
double draw_double_near(Draw& choices, const Rational& near);

/// A case of the inverse construction to generate: of any class, family and kind that is made.
GeneratorOptions draw_generator_options(Draw& choices);
/// The same of the regular family, half of the time of other shapes than quadratic triangles.
GeneratorOptions draw_regular_options(Draw& choices);

/// A generated case of those options. Near-hits of quadratic triangles are rare, as they are
/// searched for and take as long as a hundred others.
Case draw_generated(Draw& choices);

}  // namespace ccdfuzz
