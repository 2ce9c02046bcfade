#pragma once

#include "case/case.hpp"
#include "case/taxonomy.hpp"
#include "generators/generate.hpp"
#include "method/features.hpp"

namespace ccdfuzz {

/// What bodies and meshes have, unless they turn.
inline constexpr std::array kBodyCaseKinds = {CaseKind::kRP, CaseKind::kRN, CaseKind::kNMN};

/// A planted case of bodies, which it shows: of a class that the family has of the kind. It claims
/// that the numbers are floats, three times of four.
Case draw_planted(Draw& d, CaseKind kind, Family family = Family::kBodies, bool in_plane = false);

/// A mutant of queries of bodies, which it shows. They may overlap at the start, and may have a
/// separation.
Query draw_mutant(Draw& d, const Query& first, const Query& other);

/// Claims of a planted case of bodies: its truth holds and is of this kind, and it survives
/// a file. Those methods take it that have all features that it needs.
void claim_planted_truth(const Case& known, CaseKind kind, const Features& needs);

/// Claims of two decisions of the same bodies: both say the same, and neither has its witness at a
/// time at which the other is clear. Discarded where one is undecided.
void claim_same_time(const Truth& one, const Truth& other);

/// The oracle says the same of bodies that are given otherwise: swapped, scaled, and with points in
/// another order. Turns have other lengths, and spins are along other axes. A mesh has its faces in
/// another order, one of them twice, and a point more. truth: what it says of the query.
void claim_same_otherwise(Draw& d, const Query& query, const Truth& truth);

}  // namespace ccdfuzz
