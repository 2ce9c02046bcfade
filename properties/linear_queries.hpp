#pragma once

#include <functional>
#include <string>

#include "ccd/search.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// The binary places from the lowest bit of a coordinate to above its highest, velocities times
/// t_max: the most of all three coordinates.
int most_places(const Query& query);

/// Checks that a method neither misses the first contact of a degenerate linear query
/// (draw_linear), which exact arithmetic finds, nor reports it late.
std::function<void(Draw&)> misses_nothing_linear(std::string method, SearchOptions options);

}  // namespace ccdfuzz
