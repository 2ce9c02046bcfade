#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "bezier/cell.hpp"
#include "ccd/exclusion.hpp"
#include "ccd/search.hpp"

namespace ccdfuzz {

struct TraceOptions {
  /// Cells are followed down to this width, at which a full query reports a hit.
  double precision = SearchOptions().precision;
  /// Several children of a pair contain the witness where it lies on their edges. Then follow all
  /// of them, or only the lowest child of each patch (and the earlier half of the window).
  bool all = false;
  /// Write down every pair on the way, too (Trace::steps).
  bool steps = false;
};

/// A pair of cells on the way, and its window before the test.
struct TracePlace {
  int level = 0;  ///< depth of the cells: 0 for the whole patches
  std::array<Cell, 2> cells{};
  Window window{};
};

/// What became of a witness (t*, uv1, uv2) in a method's own inclusion tests (its subdivision,
/// windows and axes), with every comparison of t* exact.
///
/// A lost witness is a violation of the method's soundness: a pair of cells that touch at t* was
/// discarded, or its window cut such that t* is outside. A full query may still answer well, by
/// another pair.
struct Trace {
  /// The witness was lost in at least one of the lineages that were followed.
  bool lost = false;
  /// Pairs that were tested, and those of them in which the witness was lost.
  std::uint64_t pairs = 0, lost_pairs = 0;
  /// Exclusions that claim t* itself; in a lost pair there is at least one. Where the exclusion is
  /// inside the window, the window keeps t* nevertheless.
  std::uint64_t false_claims = 0;
  /// Depth of the last cells.
  int levels = 0;

  /// The first loss: where, by which axis (−1 if no axis claims t*), and what was left of the
  /// window, if anything.
  struct Loss {
    TracePlace place;
    ExcludedInterval by;
    std::optional<Window> left;
  };
  std::optional<Loss> loss;

  /// By how much t* survived: how many doubles are between t* and the nearest time that an axis
  /// excludes from a pair that contains the witness. The least over all pairs and axes. It is
  /// counted from the double next to t* on the side of the exclusion. So it is 0 where the
  /// exclusion ends in t* or before the next double, or claims t*. Nothing if no axis excludes a
  /// part of any window: so for trad, which drops whole ones, unless the witness is lost. Between
  /// times of one binade a step is an ulp of t*.
  struct Margin {
    std::uint64_t ulps = 0;
    TracePlace place;
    ExcludedInterval by;
  };
  std::optional<Margin> margin;

  /// For methods that compare at the ends of windows: how near an axis was to excluding t*. It is
  /// the SignedGap at t*, linear between both ends, in its unit; least over all pairs and axes.
  /// tdibm-c: in multiples of its error bound E, 1 where the computed gap is 0. At a loss of t* at
  /// an end of the window it is < 0. In exact arithmetic it is never < 1. trad: overlap in ulps of
  /// the heights, < 0 at a loss. Computed in double precision: a guide, no proof.
  struct Slack {
    double value = 0;
    TracePlace place;
    SignedGap gap;
  };
  std::optional<Slack> slack;

  /// One pair that contains the witness: the rest of its window after the test, and its own margin.
  /// There is none where no axis excludes anything; at a loss it is 0 ulps.
  struct Step {
    TracePlace place;
    std::optional<Window> left;
    bool lost = false;
    std::optional<Margin> margin;
  };
  /// Every pair, in the order of the tests, if TraceOptions::steps asked for them.
  std::vector<Step> steps;
};

}  // namespace ccdfuzz
