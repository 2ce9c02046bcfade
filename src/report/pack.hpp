#pragma once

#include <string>
#include <string_view>

namespace ccdfuzz {

/// The bytes compressed as gzip (RFC 1952), the same for the same bytes, in base64 (RFC 4648).
std::string gzip_base64(std::string_view bytes);

/// JSON or any other text made safe inside a <script> element: no "</" and no "<!--" is left.
/// Requires JSON, which has "<" in strings alone.
std::string script_safe(std::string json);

}  // namespace ccdfuzz
