#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"

namespace ccdfuzz {

/// "00ff1a": bytes as pairs of hex digits.
std::string to_hex_bytes(std::string_view bytes);
/// Errors: other digits than 0-9a-f, or an odd number of them.
Result<std::string> parse_hex_bytes(std::string_view text);

}  // namespace ccdfuzz
