#pragma once

#include <map>

#include "generators/generate.hpp"
#include "method/features.hpp"
#include "properties/no_false_negative.hpp"

namespace ccdfuzz {

/// A kind of queries beyond those of plain patches that are to touch.
struct QueryKind {
  std::string subject;  ///< of the names of its claims: "weights"
  std::string kind;     ///< of the names of its contact claims: "weighted"
  std::string of;       ///< what sentences say after "contact": "of rational patches"
  /// Where it is said what a method makes of it, if that is not the method's own source.
  std::map<std::string, std::string> sources;
  bool Features::*feature;         ///< what a method takes that takes it
  std::array<Family, 2> families;  ///< those that make such contacts, too
  DrawCase draw;  ///< contacts; of trimmed patches also such as are off their regions
};

/// A point of a patch by definition, Σ w·B·p / Σ w·B of its control points p at t.
Vec3<Rational> point_of(const MovingPatch<double>& patch, const Uv<Rational>& uv,
                        const Rational& t);

/// The checker accepts a witness iff it is in [0, t_max] and in both regions, and its points are no
/// farther apart than the separation. It is that of the case, or one thing is changed: its time or
/// place, the time step, a patch or the separation.
void claim_judged_by_meaning(Draw& d, Case known);

/// Appends the claims of a kind:
/// - SUBJECT.meaning: generator, checker, files, fuzzers and methods agree on it;
/// - SUBJECT.decision_is_proven: the checker accepts what the oracle says;
/// - those of add_contact_claims.
void add_claims_of(std::vector<Property>& claims, const QueryKind& kind);

}  // namespace ccdfuzz
