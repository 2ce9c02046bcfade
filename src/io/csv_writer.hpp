#pragma once

#include <string_view>

#include "io/fields.hpp"

namespace ccdfuzz {

/// An archive that makes CSV of a record that holds no others. A field that JSON leaves out is
/// there, so that all lines have the same cells; of what is absent the cell is empty.
class CsvWriter {
 public:
  static constexpr bool kReads = false;

  template <class T, class... Checks>
  void operator()(std::string_view name, const T& value, const Checks&...) {
    const std::string_view comma = header_.empty() ? "" : ",";
    header_.append(comma).append(name);
    cells_.append(comma);
    if constexpr (std::convertible_to<T, std::string_view>) {
      append_text(value);
    } else if (const std::string json = to_json(value); json != "null") {
      cells_ += json;
    }
  }
  template <class T, class... Rest>
  void optional(std::string_view name, const T& value, const Rest&...) {
    (*this)(name, value);
  }

  /// The names of the fields, and their values, without the line's end.
  const std::string& header() const { return header_; }
  const std::string& cells() const { return cells_; }

 private:
  /// In quotes where it holds what divides cells or lines.
  void append_text(std::string_view text) {
    const bool is_quoted = text.find_first_of(",\"\r\n") != text.npos;
    if (is_quoted) cells_ += '"';
    for (const char c : text) cells_.append(c == '"' ? 2 : 1, c);
    if (is_quoted) cells_ += '"';
  }

  std::string header_, cells_;
};

/// A line of names, and one for each of the records. Empty if there are none.
template <class Records>
std::string to_csv(const Records& records) {
  std::string csv;
  for (const auto& record : records) {
    CsvWriter line;
    visit_fields(line, record);
    if (csv.empty()) csv = line.header() + "\n";
    csv += line.cells() + "\n";
  }
  return csv;
}

}  // namespace ccdfuzz
