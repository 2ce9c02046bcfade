#pragma once

#include <cstdint>

#include "ccd/certified/normalise.hpp"

namespace ccdfuzz::certified {

/// What doubles and their error bounds tell of two linear patches in [from, t_max].
struct RoughContact {
  enum class Kind : std::uint8_t {
    kNone,    ///< they touch at no such time
    kProven,  ///< they touch at no t in [from, time), and at one in [time, time + width]
    kOpen,    ///< not decided
  };
  Kind kind = Kind::kOpen;
  double time = 0;
};

/// Decides nearly all linear queries that are not degenerate, in a far shorter time than integers
/// take (DERIVATION.md, 7, L9).
/// Law L9: if all coefficients in Bernstein's basis are beyond their error bound on one side, that
/// is the polynomial's sign throughout the window. Let m be the largest coordinate of a corner at
/// its ends, and e < 2^-20·m an error bound of all. Then coefficients are off by less than 6·m·e
/// for crosses, and by less than 96·m²·e for determinants. Law L1 decides from signs. A contact is
/// proven where the determinant has opposite signs at the ends of a window, and all crosses have
/// one sign in one component. [from, first] is looked at before the rest, if first > from: where a
/// contact is likely. Times are normalised. Requires is_linear_pair, 0 ≤ from ≤ t_max, width ≥ 0
/// and FpGuard::holds(). With the width 0 no contact is proven: so it is where t_max is 0.
RoughContact rough_contact(const NormalisedQuery& query, double from, double first, double width);

}  // namespace ccdfuzz::certified
