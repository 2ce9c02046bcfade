#pragma once

#include <cstdint>

#include "case/query.hpp"

namespace ccdfuzz::certified {

/// What exact arithmetic finds of a linear query. The patches touch at no time before `toi`.
struct LinearContact {
  enum class Kind : std::uint8_t {
    kNone,     ///< they touch at no t in [0, t_max]
    kProven,   ///< they touch, first at `toi` or soon after
    kOpen,     ///< not decided: roots that 2^-512·t_max does not part (Law L3)
    kTooWide,  ///< not decided, and nothing is known: numbers of too many binary places (Law L7)
  };
  Kind kind = Kind::kTooWide;
  double toi = 0;
  bool is_short = false;  ///< short_contact decided
};

/// Decides a linear query in integers, without rounding and without allocating (DERIVATION.md, 7).
/// Up to level kShortLevel short_contact is asked first. What it leaves open is tried at each root
/// that may be the first contact (Law L2), by the polygon there (Law L1).
/// It covers a query if the numbers of each coordinate by itself are multiples of one power of two,
/// and less than 2^254 times it. These numbers are positions, and velocities times t_max. A proven
/// contact is at toi + 2^-level·t_max at most, but for the rounding of toi (Law L8); level ≤ 50.
/// Requires finite numbers, t_max ≥ 0 and is_linear_pair.
LinearContact first_linear_contact(const Query& query, int level);

}  // namespace ccdfuzz::certified
