#pragma once

// nlohmann's lexer asserts that strtod understood all of a number, which it does not under a locale
// with a decimal comma. Its value is not used: json_real.cpp reads the text, under any locale.
#define JSON_ASSERT(condition) static_cast<void>(0)
#include <nlohmann/json.hpp>
