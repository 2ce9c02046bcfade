#pragma once

#include <array>

#include "ccd/time_interval.hpp"

namespace ccdfuzz::certified {

// What a build with assertions remembers of computed numbers, and checks where they meet. Other
// builds have the same types without members.

#ifdef NDEBUG

struct Provenance {
  Provenance() = default;
  Provenance(const Window& /*window*/, int /*roundings*/) {}
};

struct Basis {
  Basis() = default;
  Basis(double /*magnitude*/, double /*absolute*/, int /*roundings*/) {}
};

#else

/// Where numbers at both ends of a window come from: the window, and how many roundings are behind
/// the control points. Laws A and B are of the ends of one window.
struct Provenance {
  Window window{};
  int roundings = 0;

  Provenance() = default;
  Provenance(const Window& w, int behind_each) : window(w), roundings(behind_each) {}
  bool is_of(const Window& w) const { return window.lo == w.lo && window.hi == w.hi; }
};

/// What error bounds were made from, and the 1-norms of their axes. Law C holds for no more
/// roundings than these.
struct Basis {
  double magnitude = 0, absolute = 0;
  int roundings = 0;
  std::array<double, 4> norms{};

  Basis() = default;
  Basis(double largest, double absolute_part, int most_roundings)
      : magnitude(largest), absolute(absolute_part), roundings(most_roundings) {}
};

#endif

}  // namespace ccdfuzz::certified
