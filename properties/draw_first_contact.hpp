#pragma once

#include "case/case.hpp"
#include "ccd/search.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

inline constexpr double kFinePrecision = 0x1p-10;
inline constexpr SearchOptions kFineSearch = {kFinePrecision, 2000, SearchOptions().max_bytes};

/// A one-sided scene with the witness of its first contact, which is proven. Control points of a
/// cell of width h are within n·h times the patch's extent of each other, n the degree. So boxes
/// that a method cannot separate are that near. The gap along the plane's normal closes at a known
/// speed.
struct FirstContact : Case {
  double early = 0;  ///< a hit at kFinePrecision is explained if it comes this much before
};

/// apart: patch 1 is moved away along the normal, so that the patches come no nearer than a
/// distance, which is the query's separation, rounded up. Discarded: a number is not a double.
FirstContact draw_first_contact(Draw& choices, bool apart = false);

/// The method hits, no earlier than explained. Discarded: it is undecided. Shows all.
void claim_not_early(const std::string& method, const FirstContact& drawn, Draw& draw,
                     const SearchOptions& search = kFineSearch);

}  // namespace ccdfuzz
