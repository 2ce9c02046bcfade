#pragma once

#include <string>

#include "case/case.hpp"

namespace ccdfuzz {

/// The same shapes, at rest and far apart: what is asked between a query and its repetition.
Query decoy_query(const Query& query);

/// A query with one coordinate that is NaN or infinite.
struct PoisonedQuery {
  Query query;
  std::string where;  ///< "patches[0].velocities[2][1] = nan"
};

/// Which coordinate, and what stands there, follows from the query alone; over many queries it is
/// each.
PoisonedQuery poisoned_query(const Query& query);

}  // namespace ccdfuzz
