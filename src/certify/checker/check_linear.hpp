#pragma once

#include "case/case.hpp"
#include "certify/checker/work.hpp"

namespace ccdfuzz {

/// True iff the certificates below speak of these patches: points, curves of degree 1 and triangles
/// of degree 1, with at most two parameters in all.
bool is_linear_query(const Query& query);

/// Both certificates are about triangles whose corners a, b, c are differences of control points of
/// the patches, and move linearly. A point and a triangle have one. Two edges have two, on either
/// side of a diagonal of the parallelogram. The patches touch iff a triangle contains the origin.
/// With
///   D = a·(b×c),  n = (b×c, c×a, a×b),  s_i = n_j·n_k,  m = Σ|n_i|²,  d_i = dots of two corners,
/// it does iff D = 0, all s_i ≥ 0, and m > 0 or some d_i ≤ 0.
/// Proof. If m > 0 and D = 0, then a, b, c span a plane with normal ν. Up to a factor ν·n are the
/// only coefficients that give 0 from a, b, c. They are weights iff they do not differ in sign. If
/// m = 0, all are on a line through 0, which is between two or at one iff some d_i ≤ 0. If D ≠ 0, 0
/// is no combination of a, b, c at all.

/// Certificate L: decides, in exact integers, that linear patches are farther apart than the
/// separation. It is so at every t in [0, until), or in the closed [0, until]. Shares no code with
/// the search for contacts.
/// [0, until] is halved until the coefficients of Bernstein of D, an s_i or all d_i have one sign.
/// The origin is outside if D ≠ 0, some s_i < 0, or all d_i > 0 (as then a·(αa + βb + γc) > 0 or
/// likewise for b, c). At any time without contact one of them is so, strictly, so this ends.
/// With a separation > 0 it is halved until one direction shows it (linear_directions.hpp). That
/// ends, too, unless patches come exactly as near as that, no nearer, and at no dyadic part of
/// `until`.
/// Requires a valid query. Errors: it is not linear; a contact; not decided within 4,000 halvings;
/// more than most_work.
Result<void> check_linear_clearance(const Query& query, const LinearClearance& clearance,
                                    std::uint64_t most_work = kMostWork);

/// Certificate R: checks in exact arithmetic that linear patches are in contact at the root.
/// Proof. The polynomial p changes its sign between `from` and `by`, so it has a root there. The
/// following holds for one of the triangles. p divides D, so that D is 0 at the root. p divides
/// s_i, or s_i ≥ 0 by its coefficients of Bernstein on [from, by]. m > 0 by its, or p divides some
/// d_i, or d_i ≤ 0 by its.
/// With a separation > 0 they are as near as that at the root, by one of the points of a triangle
/// that LinearDirections::nearness describes. At the root its weights are ≥ 0, their sum is > 0,
/// and it is no farther from the origin. The sum has its sign by its coefficients. The others have
/// theirs by these, or p divides them.
/// Requires a valid query. Errors: what is wrong, naming the field; more than most_work.
Result<void> check_contact_root(const Query& query, const ContactRoot& root,
                                std::uint64_t most_work = kMostWork);

}  // namespace ccdfuzz
