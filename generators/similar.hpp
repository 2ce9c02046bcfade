#pragma once

#include <optional>

#include "case/case.hpp"

namespace ccdfuzz {

/// A change of coordinates that moves both patches alike, so that they touch where and when they
/// did: x → 2^space·(x + t·drift + shift), t → 2^time·t.
struct Similarity {
  Vec3<double> shift = Vec3<double>(0, 0, 0);
  Vec3<double> drift = Vec3<double>(0, 0, 0);  ///< a velocity common to both
  int space = 0;
  int time = 0;
};

/// The query in other coordinates. nullopt if any number of it is not a double then, or a body of
/// it turns.
std::optional<Query> similar(const Query& query, const Similarity& change);

/// The case in other coordinates, with the same truth. A miss tree is dropped, so that only a new
/// search proves absence of contact. Expectations are dropped: they were of another query. nullopt
/// if any number of it is not a double then, or a contact box proves its contact.
std::optional<Case> similar(const Case& value, const Similarity& change);

/// The query from where it is at t; t_max stays. nullopt where that rounds, or the query has ends
/// or turns.
std::optional<Query> begun_at(Query query, const Rational& t);

/// The patches in the other order.
Query swapped(const Query& query);

/// Each point's coordinates moved on by `by` places, and then that of one axis negated, if any is
/// given. Requires that no body turns by quaternions, and none at all in a mirror, where no mesh is
/// one-sided.
Query on_other_axes(Query query, int by, std::optional<int> mirrored = {});

}  // namespace ccdfuzz
