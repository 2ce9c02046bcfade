#pragma once

#include <string>
#include <vector>

#include "case/query.hpp"
#include "ccd/search.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// The oracle decides a linear query, and the independent checker accepts every certificate: both
/// exact codes agree, on contacts and on absence. Requires linear::is_linear.
Check linear_decision_is_proven(const Query& query);

/// The method neither misses the first contact of a linear query, which exact arithmetic finds,
/// nor reports it late. Discarded: there is none.
Check no_false_negative_on_linear(const std::string& method, const Query& query,
                                  const SearchOptions& options);

/// The binary places from the lowest bit of a coordinate to above its highest, velocities times
/// t_max: the most of all three coordinates.
int most_places(const Query& query);

/// tdibm-c has the verdict of exact arithmetic on a linear query, and a toi that is neither late
/// nor early by more than options.precision of t_max. Requires that most_places is 254 at most, as
/// first_linear_contact promises.
Check linear_answer_is_exact(const Query& query, const SearchOptions& options);

/// These on queries that are degenerate in every way (draw_linear), and what doubles decide of
/// ordinary ones.
std::vector<Property> linear_properties();

}  // namespace ccdfuzz
