#pragma once

#include <optional>
#include <vector>

#include "case/case.hpp"
#include "case/taxonomy.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// A query and a contact of it, in the form that mutation works on: doubles for the patches, dyadic
/// numbers for where and when they touch.
/// Invariant of a whole one: patch 1 at uv[0] and patch 2 at uv[1] are at one point at t, exactly,
/// and 0 ≤ t ≤ query.t_max.
struct WitnessedQuery {
  Query query;
  Dyadic t;
  std::array<Uv<Dyadic>, 2> uv;

  /// The weights of patch `side`'s control points at the contact.
  std::vector<Dyadic> weights(int side) const;
  /// Where patch `side` has the contact.
  Vec3<Dyadic> contact(int side) const;
  /// The contact, as truths hold it.
  Witness witness() const;
};

/// The witnessed contact of a case. nullopt if its truth has no witness within t_max, or one that
/// is not dyadic.
std::optional<WitnessedQuery> witnessed_query(const Case& known);

/// Where on the patches the contact lies. A curve is an edge, its ends and a point are corners.
ContactClass contact_class_of(const WitnessedQuery& q);

/// A point that falls on a line: what an empty corpus begins with.
WitnessedQuery falling_point();

/// A case that says of the query what is proven: the witness, and nothing of the time before it.
Case case_of(const WitnessedQuery& q);

/// x += by. Returns false, and leaves x, if the sum is not a double.
bool add_exactly(double& x, const Dyadic& by);
bool add_exactly(Vec3<double>& x, const Vec3<Dyadic>& by);

/// Makes an edited query whole again: moves a patch, or a control point or the velocity of one,
/// by what is between the two patches at the contact. Returns false if no way is exact.
bool repair(WitnessedQuery& q, Draw& draw);

}  // namespace ccdfuzz
