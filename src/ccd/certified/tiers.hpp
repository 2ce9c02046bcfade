#pragma once

#include <cstdint>

namespace ccdfuzz::certified {

/// What decided, how often, over the life of a solver: so that a test can show that each tier does.
struct Tiers {
  // Linear queries, by the tier that answered.
  std::uint64_t advancement = 0;  ///< clear by following axes (Laws A and C)
  std::uint64_t doubles = 0;      ///< rough_contact (Law L9)
  /// first_linear_contact (Laws L1 to L8), also where it left the query open
  std::uint64_t integers = 0;

  // Splits of which a pair of children was dropped by a shared axis that separates it throughout.
  std::uint64_t coordinate = 0;  ///< a coordinate axis (Laws A and C)
  std::uint64_t shared = 0;      ///< the hint or a normal of the parents (Laws A and C)

  // Pairs of children that were dropped by axes of their own.
  std::uint64_t own = 0;       ///< by one that separates them throughout (Laws A and C)
  std::uint64_t together = 0;  ///< by several, each in a part of the window (Laws A and B)

  // Axes that shortened a window.
  std::uint64_t chord = 0;   ///< by Law B
  std::uint64_t newton = 0;  ///< by more than that, with Newton's iteration (Laws A and C)

  std::uint64_t postponed = 0;  ///< coarse pairs that were not put to all axes
};

}  // namespace ccdfuzz::certified
