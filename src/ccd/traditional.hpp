#pragma once

#include <array>
#include <optional>
#include <span>

#include "ccd/exclusion.hpp"
#include "ccd/search.hpp"
#include "ccd/sub_patches.hpp"

namespace ccdfuzz {

/// How the boxes of the traditional method are aligned.
enum class BoxKind {
  kOriented,     ///< as ObbAxes at the start of the window
  kAxisAligned,  ///< with the coordinate axes
};

/// The traditional inclusion test (Section 6 (1); Snyder 1992, Von Herzen et al. 1990): over a
/// window each sub-patch stays within the hull of its control points at both ends. So two of them
/// may touch only if the boxes of those hulls overlap. Nothing guards the rounding. Safe in exact
/// arithmetic: never drops a window with a contact.
class TraditionalInclusion {
 public:
  /// Time is the fifth parameter that is subdivided.
  static constexpr bool kSplitsTime = true;

  explicit TraditionalInclusion(BoxKind kind = BoxKind::kOriented,
                                const AxisReading& axes = kTraditionalAsReleased)
      : kind_(kind), parts_(axes) {}

  void begin(const Query& query) { parts_.begin(query); }
  void prepare(int side, std::span<const Cell> parts) { parts_.prepare(side, parts); }
  std::optional<Window> test(int part_a, int part_b, const Window& window,
                             ExclusionObserver* observer = nullptr);

 private:
  BoxKind kind_;
  SubPatches parts_;
  std::array<Points<double>, 2> sweeps_;  ///< control points at both ends of the window
};

/// `trad` (oriented boxes, as the paper uses it) and `trad:aabb`.
using Traditional = Search<TraditionalInclusion>;

}  // namespace ccdfuzz
