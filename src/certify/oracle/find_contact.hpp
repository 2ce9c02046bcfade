#pragma once

#include <optional>

#include "case/case.hpp"

namespace ccdfuzz {

/// Where a method has found a hit: near these parameters, to within about `width`, near time t.
struct ContactGuess {
  std::array<Uv<double>, 2> uv{};
  double t = 0;
  double width = 0;
};

/// An exact witness (certificate W) near the guess, at a time ≤ t_max, or nothing. Tries as
/// parameters the simplest dyadic and other rationals in growing intervals about the guess, and
/// those of loops' vertices there. Then it tries simple parts of the way along the nearest edge of
/// a loop. The time is then the exact root of a linear equation. What is returned passed
/// check_witness.
std::optional<Witness> find_witness(const Query& query, const ContactGuess& guess);

/// A contact box (certificate M) near the guess that ends at a time ≤ t_max, the earliest of
/// those found, or nothing. Each choice of three unknowns is tried: Newton's method finds them from
/// the guess, and the box grows until the checker accepts it. What is returned passed check_box.
std::optional<ContactBox> find_contact_box(const Query& query, const ContactGuess& guess);

}  // namespace ccdfuzz
