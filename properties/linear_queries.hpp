#pragma once

#include <functional>
#include <string>

#include "ccd/search.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// Checks that a method neither misses the first contact of a degenerate linear query
/// (draw_linear), which exact arithmetic finds, nor reports it late.
std::function<void(Draw&)> misses_nothing_linear(std::string method, SearchOptions options);

}  // namespace ccdfuzz
