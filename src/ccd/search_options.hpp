#pragma once

#include <cstdint>
#include <limits>

namespace ccdfuzz {

/// Limits of one query; exhaustion is Undecided, with the earliest time at which a contact may
/// still be. max_pops and max_bytes are deterministic. Their defaults let every generated query
/// end, and end what cannot (patches that coincide over an area need 4^depth pairs): tdibm-c
/// within about a second, by memory, and all within 256 MiB. A queue that grows copies itself
/// once, so max_bytes is half.
struct SearchOptions {
  double precision = 1e-4;  ///< parameter width at which a pair of cells is a hit; in (0, 1]
  std::uint64_t max_pops = 1'000'000;   ///< pairs taken from the queue
  std::uint64_t max_bytes = 128 << 20;  ///< memory of the queue
  /// Wall time, not NaN; looked at every Deadline::kPopsBetweenLooks pops.
  double max_seconds = std::numeric_limits<double>::infinity();
};

}  // namespace ccdfuzz
