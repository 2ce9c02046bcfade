#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ccdfuzz {

/// "00ff1a": bytes as pairs of hex digits.
std::string to_hex_bytes(std::string_view bytes);
/// Nothing where there are others than the digits 0-9a-f, or an odd number of them.
std::optional<std::string> parse_hex_bytes(std::string_view text);

}  // namespace ccdfuzz
