#pragma once

#include <compare>
#include <functional>

#include "finds/content_address.hpp"
#include "generators/contact.hpp"

namespace ccdfuzz {

/// How simple a query and its contact are, simplest first. It begins with CaseSize, by which a
/// store compares.
struct Simplicity {
  CaseSize size;
  std::uint64_t witness_bits = 0;      ///< in t and uv
  std::uint64_t different_points = 0;  ///< and what else a query has more or less of, such as faces
  std::uint64_t exponents = 0;         ///< sum of |exponent| of all coordinates and weights
  friend auto operator<=>(const Simplicity&, const Simplicity&) = default;
};

Simplicity simplicity_of(const Contact& q);

/// Gets a simpler form. Returns whether it was taken: then what is offered next starts from it.
using Offer = std::function<bool(const Contact&)>;

/// Offers the query as `change` leaves it, if that is another. Returns whether it was taken.
bool offer_changed(const Contact& q, const Offer& offer, const auto& change) {
  Contact next = q;
  change(next.query);
  return next.query != q.query && offer(next);
}

/// Offers simpler forms of a query, the boldest first; the contact may be broken in them. `offer`
/// puts the form that it takes where the reference stands. One round through all kinds of
/// simplification; a second one may do more.
void offer_simpler(const Contact& current, const Offer& offer);
/// The part of that which is for bodies alone: fewer faces and points, no turn, one that rests,
/// about the origin.
void offer_simpler_bodies(const Contact& current, const Offer& offer);

}  // namespace ccdfuzz
