#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace ccdfuzz {

enum class JsonKind : std::uint8_t { kNull, kBool, kNumber, kString, kArray, kObject };

/// One JSON value as in the text. Numbers keep their text, so that nothing is rounded
/// before the reader knows what it wants of them.
struct JsonValue {
  JsonKind kind = JsonKind::kNull;
  std::string text;               ///< number: as written; string: its contents; bool: true, false
  std::vector<std::string> keys;  ///< object: one for each of items, all different
  std::vector<JsonValue> items;   ///< array, object

  /// The member of an object, or null.
  const JsonValue* find(std::string_view key) const;
  /// The same, whatever the order of an object's keys.
  bool operator==(const JsonValue& other) const;
};

/// Limits that keep hostile text from exhausting time or memory; a case stays far below them.
inline constexpr size_t kMaxJsonDepth = 64;
inline constexpr size_t kMaxJsonKeys = 1024;

/// Reads one JSON text (RFC 8259; a UTF-8 byte order mark is skipped) and nothing after it. Errors:
/// anything else, a key given twice in an object, a number out of a double's range. Each names
/// `file`, and the line and column or the JSON path.
Result<JsonValue> parse_json(std::string_view text, const std::string& file);

/// A value for a message: numbers and short strings as written, "an array", "an object".
std::string shown(const JsonValue& value);

/// path + ".key", or path + "[\"key\"]" where the key is not a plain word; "key" if path is empty.
std::string member_path(const std::string& path, std::string_view key);

}  // namespace ccdfuzz
