#pragma once

#include <string>
#include <string_view>

namespace ccdfuzz {

/// 32 hex digits that name these bytes: their 128-bit XXH3 hash.
std::string hash_name(std::string_view bytes);

}  // namespace ccdfuzz
