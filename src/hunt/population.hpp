#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <vector>

#include "ccd/witness_trace/trace.hpp"
#include "generators/contact.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// What decided how nearly a contact was lost: of contacts that differ in it, each may be the way
/// to a loss of its own.
struct Niche {
  enum class By : std::uint8_t {
    kNothing,        ///< nothing was excluded
    kExcludedStart,  ///< an exclusion that begins with the window
    kExcludedRest,   ///< one that begins later
    kGap,            ///< the gap at an end of a window (SignedGap)
  };
  By by = By::kNothing;
  std::int16_t level = 0;  ///< the pair's (TracePlace)
  std::int16_t axis = 0;   ///< among those that the method tries

  friend auto operator<=>(const Niche&, const Niche&) = default;
};

/// A contact's place in a population.
struct Standing {
  Niche niche;
  double nearness = 0;  ///< how near it is to being lost; less is nearer
};

/// How nearly the contact of q was lost in its trace, and in which niche. For methods that compare
/// at the ends of windows: the slack. For the others: how far apart the patches are where the
/// nearest exclusion ends. That is the time to the contact times the closing speed. The unit is
/// what rounding may do to a height (2^-53 of the largest on the way). Time alone would favour fast
/// patches over badly rounded ones. Computed in double precision: a guide, no proof.
Standing standing_of(const Contact& q, const Trace& trace);

/// The contacts that came nearest to being lost, one per niche. So a contact that nearly fails in
/// one way cannot displace those of other ways.
class Population {
 public:
  /// Takes the place of a member of its niche that is no nearer: of equals the younger stays, so
  /// that the population drifts.
  void join(Contact q, const Standing& standing);

  bool empty() const { return members_.empty(); }
  /// The nearer of two that are drawn. Requires a member.
  const Contact& nearer_of_two(Draw& draw) const;

 private:
  struct Member {
    Contact q;
    double nearness;
  };

  std::vector<Member> members_;
  std::map<Niche, std::size_t> places_;  ///< in members_
};

}  // namespace ccdfuzz
