#pragma once

#include <string>
#include <string_view>

namespace ccdfuzz {

/// The text as a JSON string, quotes included. Bytes that are not UTF-8, as file names may have
/// them, become U+FFFD: whatever they are is shown, not refused.
std::string json_string(std::string_view text);

/// The shortest JSON number that reads back as the finite x, bit by bit; −0 is -0.0.
std::string json_number(double x);

/// One line of JSON as people read it. What fits into a line of 100 columns stays on one. Other
/// objects and arrays have a line for each member. Requires a text that parse_json reads.
std::string readable_json(std::string_view json);

}  // namespace ccdfuzz
