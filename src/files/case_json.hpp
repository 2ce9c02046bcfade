#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "case/case.hpp"

namespace ccdfuzz {

class JsonCursor;
template <class T>
struct JsonForm;

/// A case as a field of a record: the format of docs/formats.md.
template <>
struct JsonForm<Case> {
  static void write(std::string& json, const Case& value);
  static void read(const JsonCursor& from, Case& value);
};

/// Reads one case from its JSON text, the format of docs/formats.md. Reals are JSON numbers or
/// hex-float strings (parse_exact_real: 0.1 is the double nearest to it, longer decimals must be
/// doubles). Exact values are strings "p" or "p/q". The truth is read, not believed: see
/// certify/checker/check_truth.hpp. Errors name `file`, the JSON path and the value. They are: not
/// JSON; a duplicate, unknown or missing key; a wrong type, format, version, count or degree; a
/// real out of range. Also t_max < 0, collides without its witness or proof, and an unknown
/// outcome. Only `origin` may hold keys of its own, with strings or numbers, which are kept.
Result<Case> parse_case(std::string_view json, const std::string& file);

/// Reads the query of a JSON text that has patches and t_max as a case does, whatever else it has.
/// Errors: as parse_case.
Result<Query> parse_query(std::string_view json, const std::string& file);

enum class JsonLayout : std::uint8_t {
  kOneLine,   ///< for data sets
  kReadable,  ///< readable_json: for files that people read and compare
};

/// The case as JSON without a final newline; the same bytes for the same case everywhere.
/// Empty fields are left out. Requires finite numbers. parse_case gives the same case back.
std::string to_json(const Case& value, JsonLayout layout = JsonLayout::kOneLine);

}  // namespace ccdfuzz
