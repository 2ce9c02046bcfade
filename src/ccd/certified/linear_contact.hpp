#pragma once

#include <cstdint>

#include "case/query.hpp"

namespace ccdfuzz::certified {

/// What exact arithmetic finds of a linear query. The patches touch at no time before `toi`.
struct LinearContact {
  enum class Kind : std::uint8_t {
    kNone,     ///< they touch at no t in [0, t_max]
    kProven,   ///< they touch, first at `toi` or soon after (Law L8)
    kOpen,     ///< not decided: roots of two polynomials that 2^-1900·t_max does not part (Law L5)
    kTooWide,  ///< not decided, and nothing is known: numbers of too many binary places (Law L7)
  };
  Kind kind = Kind::kTooWide;
  double toi = 0;
};

/// Decides a linear query in integers, without rounding and without allocating (DERIVATION.md, 7).
/// Each root that may be the first contact is tried (Law L2), by the polygon there (Law L1).
/// Law L2: the first contact is at 0 or at a root of the determinant. If that is 0 throughout, the
/// first contact is at 0 or at a root of a cross. If crosses are 0 throughout, too, it is at 0 or
/// at a root of a corner's coordinate.
/// Each root is the only one in a part of the time step (Law L3), or one is repeated. Then all
/// roots are ratios of integers, as the degree is 3 at most (Law L4). The sign of another
/// polynomial there is found, too (Law L5). Integers fit (Law L6).
/// Law L7: it covers a query if the numbers of each coordinate by itself are multiples of one power
/// of two, and less than 2^254 times it. These numbers are positions, and velocities times t_max.
/// Where a patch has ends, its positions times t_max and its ends times t_max count in place of
/// velocities times t_max. They are less than 2^253 times it.
/// Law L8: a proven contact is at toi or later, and by toi + 2^-level·t_max, but for the rounding
/// of toi. That is less than 2^-48·toi + 2^-1073; level ≤ 50.
/// Requires finite numbers, t_max ≥ 0 and is_linear_pair.
LinearContact first_linear_contact(const Query& query, int level);

}  // namespace ccdfuzz::certified
