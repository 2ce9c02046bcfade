#include "method/features.hpp"

#include "case/refusal.hpp"

namespace ccdfuzz {

TakenQuery::TakenQuery(const Query& query, const Features& features) : query_(&query) {
  const bool is_apart = query.separation > 0 && !features.separation;
  const bool is_of_ends = has_ends(query) && !features.ends;
  const bool has_bodies = is_of_bodies(query) && !features.bodies;
  if ((!is_apart && !is_of_ends && !has_bodies) || !is_valid(query)) return;
  if (is_of_ends) {
    converted_ = with_velocities(query);
    query_ = converted_ ? &*converted_ : nullptr;
    why_ = "takes velocities, and not all ends − positions of this query are doubles";
  }
  if (is_apart) {
    query_ = nullptr;
    why_ = "knows touching alone, and this query has a separation";
  }
  if (has_bodies) {
    query_ = nullptr;
    why_ = kNoBodies;
  }
}

}  // namespace ccdfuzz
