#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace ccdfuzz {

/// The value as one line of JSON, without its end. Bytes that are not UTF-8, as file names may
/// have them, become U+FFFD: whatever they are is shown, not refused.
std::string json_text(const nlohmann::ordered_json& value);

}  // namespace ccdfuzz
