#pragma once

#include <string>

#include "case/case.hpp"

namespace ccdfuzz {

/// The same shapes, at rest and far apart: what is asked between a query and its repetition.
Query decoy_query(const Query& query);

/// A query with one number that is NaN or infinite: a coordinate, or the radius of a body or a
/// number of its turn.
struct PoisonedQuery {
  Query query;
  std::string where;  ///< "patches[0].velocities[2][1] = nan"
};

/// Which number, and what stands there, follows from the query alone; over many queries it is
/// each.
PoisonedQuery poisoned_query(const Query& query);

}  // namespace ccdfuzz
