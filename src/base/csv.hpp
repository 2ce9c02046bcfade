#pragma once

#include "base/fields.hpp"
#include "base/table.hpp"

namespace ccdfuzz {

/// An archive that collects the names of fields, those of records inside in their place.
class CsvHeader {
 public:
  static constexpr bool kReads = false;

  template <class T, class... Checks>
  void operator()(std::string_view name, const T& value, const Checks&...) {
    if constexpr (HasFields<T>) {
      visit_fields(*this, value);
    } else {
      append(csv_field(std::string(name)));
    }
  }
  template <class T, class... Others>
  void optional(std::string_view name, const T& value, const Others&...) {
    (*this)(name, value);
  }
  std::string line;

 protected:
  void append(const std::string& field) {
    if (!std::exchange(first_, false)) line += ',';
    line += field;
  }

 private:
  bool first_ = true;
};

/// An archive that collects the values: texts as they are, nothing for what is absent, all else as
/// in JSON.
class CsvRow : public CsvHeader {
 public:
  template <class T, class... Checks>
  void operator()(std::string_view name, const T& value, const Checks&...) {
    if constexpr (HasFields<T>) {
      visit_fields(*this, value);
    } else if constexpr (fields_detail::kIsOptional<T>) {
      value ? (*this)(name, *value) : append("");
    } else if constexpr (std::convertible_to<T, std::string_view>) {
      append(csv_field(std::string(value)));
    } else if constexpr (NamedEnum<T>) {
      append(csv_field(std::string(name_of(value))));
    } else {
      append(csv_field(to_json(value)));
    }
  }
  template <class T, class... Others>
  void optional(std::string_view name, const T& value, const Others&...) {
    (*this)(name, value);
  }
};

/// An archive that takes the fields of a line in their order. Refused: see JsonCursor, with the
/// column for a path.
class CsvRowReader {
 public:
  static constexpr bool kReads = true;

  CsvRowReader(const std::vector<std::string>& texts, const std::string& where)
      : texts_(texts), where_(where) {}

  template <class T, class... Checks>
  void operator()(std::string_view name, T& value, const Checks&...) {
    if constexpr (HasFields<T>) {
      visit_fields(*this, value);
    } else if constexpr (fields_detail::kIsOptional<T>) {
      if (texts_[next_].empty()) {
        value.reset();
        ++next_;
      } else {
        (*this)(name, value.emplace());
      }
    } else {
      read_text(name, std::is_arithmetic_v<T>, [&](const JsonCursor& at) { read_json(at, value); });
    }
  }

 private:
  /// Gives read the next text, as a number or truth or as a string.
  template <class Read>
  void read_text(std::string_view name, bool is_number, const Read& read) {
    const std::string& text = texts_[next_++];
    const std::string path = fmt::format("{}: {}", where_, name);
    const Result<JsonValue> number = is_number ? parse_json(text, path) : Result<JsonValue>();
    const JsonValue value =
        is_number && number ? *number : JsonValue{JsonKind::kString, text, {}, {}};
    read(JsonCursor(value, path));
  }

  const std::vector<std::string>& texts_;
  const std::string& where_;
  size_t next_ = 0;
};

/// The line that names the columns of the record's CSV, and the line of a record, without their
/// ends.
template <HasFields T>
std::string csv_header() {
  CsvHeader header;
  const T record{};
  visit_fields(header, record);
  return header.line;
}
template <HasFields T>
std::string csv_row(const T& record) {
  CsvRow row;
  visit_fields(row, record);
  return row.line;
}

/// The record of such a line. Errors: another number of fields, or one that is not what its column
/// holds; naming `where`, the column and the value.
template <HasFields T>
Result<T> from_csv_row(std::string_view line, const std::string& where) {
  const std::vector<std::string> texts = csv_texts(line);
  static const size_t columns = csv_texts(csv_header<T>()).size();
  if (texts.size() != columns) {
    return input_error(where, fmt::format("has {} fields, not {}", texts.size(), columns));
  }
  T record;
  try {
    CsvRowReader reader(texts, where);
    visit_fields(reader, record);
  } catch (const JsonCursor::Refusal& refusal) {
    return tl::unexpected(refusal.error);
  }
  return record;
}

}  // namespace ccdfuzz
