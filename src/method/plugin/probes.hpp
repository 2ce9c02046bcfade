#pragma once

#include <string>

#include "case/case.hpp"
#include "method/domain.hpp"

namespace ccdfuzz {

/// The query turned by 180° about the z axis. It is at twice the speed for half the time, and so
/// has another toi, if the domain takes that. It is asked between a query and its repetition.
/// Whatever is promised of one of them is promised of the other.
Query decoy_query(const Query& query, const Domain& domain);

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
