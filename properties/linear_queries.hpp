#pragma once

#include <string>
#include <vector>

#include "ccd/search.hpp"
#include "properties/property.hpp"
#include "query/query.hpp"

namespace ccdfuzz {

/// The oracle decides a linear query, and the independent checker accepts every certificate: both
/// exact codes agree, on contacts and on absence. Requires linear::is_linear.
Check linear_decision_is_proven(const Query& query);

/// The method neither misses the first contact of a linear query, which exact arithmetic finds,
/// nor reports it late. Discarded: there is none.
Check no_false_negative_on_linear(const std::string& method, const Query& query,
                                  const SearchOptions& options);

/// Both on queries that are degenerate in every way (draw_linear).
std::vector<Property> linear_properties();

}  // namespace ccdfuzz
