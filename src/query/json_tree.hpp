#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "numeric/result.hpp"

namespace ccdfuzz {

enum class JsonKind : std::uint8_t { kNull, kBool, kNumber, kString, kArray, kObject };

/// One JSON value as it stood in the text. Numbers keep their text, so that nothing is rounded
/// before the reader knows what it wants of them.
struct JsonValue {
  JsonKind kind = JsonKind::kNull;
  std::string text;               ///< number: as written; string: its contents; bool: true, false
  std::vector<std::string> keys;  ///< object: one for each of items, all different
  std::vector<JsonValue> items;   ///< array, object

  /// The member of an object, or null.
  const JsonValue* find(std::string_view key) const;
};

/// Limits that keep hostile text from exhausting time or memory; a case stays far below them.
inline constexpr size_t kMaxJsonDepth = 64;
inline constexpr size_t kMaxJsonKeys = 1024;
/// Of a number's text. The longest decimal that is exactly a double has 1,077 characters.
inline constexpr size_t kMaxNumberLength = 2000;

/// Reads one JSON text (RFC 8259; a UTF-8 byte order mark is skipped) and nothing after it.
/// Errors: anything else, a key given twice in an object, and a number out of a double's range,
/// naming `file` and the line and column or the JSON path.
Result<JsonValue> parse_json(std::string_view text, const std::string& file);

/// A value for a message: numbers and short strings as written, "an array", "an object".
std::string shown(const JsonValue& value);

/// path + ".key", or path + "[\"key\"]" where the key is not a plain word; "key" if path is empty.
std::string member_path(const std::string& path, std::string_view key);

/// The text as a JSON string, quotes included. Bytes that are not UTF-8 become U+FFFD.
std::string json_string(std::string_view text);

/// One line as people may see it: control characters, which a terminal would obey, as \u00xx or \n.
std::string shown_line(std::string_view text);
/// The same of text in which newlines end lines.
std::string shown_lines(std::string_view text);

/// The shortest JSON number that reads back as the finite x, bit by bit; −0 is -0.0.
std::string json_number(double x);

/// The double that a JSON number's text or a hex float's text ("0x1.8p-3") stands for. Decimal
/// fractions round to nearest; integers and hex floats must be doubles exactly.
/// Errors: the reason, naming the text; `where` is left to the caller.
Result<double> parse_real(const JsonValue& value);

/// The same for a case, which must say exactly what it means. A decimal of at most 17 significant
/// digits names the double nearest to it, as 0.1 does; 17 tell all doubles apart. A longer one must
/// be a double exactly. Errors: as parse_real, and a longer one that is none, naming the nearest.
Result<double> parse_case_real(const JsonValue& value);

}  // namespace ccdfuzz
