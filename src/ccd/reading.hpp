#pragma once

#include <cstdint>

namespace ccdfuzz {

/// How the separating axes of two boxes are made, where the paper and its authors' earlier program
/// differ. DERIVATION.md, "Readings", says which method follows which.
struct AxisReading {
  /// The directions that a part spans at a time t.
  enum class Spans : std::uint8_t {
    kCorners,        ///< from one corner to two others (Appendix A (c))
    kMovedSides,     ///< a rectangle's are sums over opposite sides
    kSides,          ///< the same, but positions and velocities are subtracted before they meet
    kSidesWithSlip,  ///< the same, but v of patch 2 moves as u does
  };
  enum class Length : std::uint8_t {
    kAsTheyAre,
    kUnitSpans,  ///< the spans have unit length, their products have what comes of it
    kUnit,       ///< all fifteen have
  };
  Spans spans = Spans::kCorners;
  Length length = Length::kUnitSpans;
};

/// What a method of the paper leaves open besides its robustness policy.
struct Reading {
  AxisReading axes;
  /// Steps II and III look this far past both ends of a window [time].
  double window_margin = 0;
};

/// The paper, Appendix A: the error-bounded method.
inline constexpr Reading kAsInAppendixA{};

/// The program that Chen et al. released and that the paper takes its methods (1) to (3) from.
inline constexpr Reading kAsReleased{{AxisReading::Spans::kSides, AxisReading::Length::kAsTheyAre},
                                     1e-6};
inline constexpr AxisReading kTraditionalAsReleased{AxisReading::Spans::kMovedSides,
                                                    AxisReading::Length::kAsTheyAre};

}  // namespace ccdfuzz
