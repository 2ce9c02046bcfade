#pragma once

#include "io/fields.hpp"
#include "io/table.hpp"

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

}  // namespace ccdfuzz
