#pragma once

#include <charconv>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "io/json_tree.hpp"

namespace ccdfuzz {

/// A value in a JSON text, with its file and its path there. What is not as asked is thrown as a
/// Refusal that names file, path and value. Whoever opens the text catches it (read_json_text).
class JsonCursor {
 public:
  struct Refusal {
    InputError error;
  };

  /// Holds references to both.
  JsonCursor(const JsonValue& value, const std::string& file) : value_(&value), file_(&file) {}

  /// Refuses with "file: path: what".
  [[noreturn]] void refuse(std::string what) const;
  /// Refuses with a fault of a member, of which it says where in this value it is.
  [[noreturn]] void refuse_below(const InputError& fault) const;
  /// Refuses with "file: path: VALUE why".
  [[noreturn]] void refuse_value(std::string_view why) const;

  const JsonValue& value() const { return *value_; }
  bool is_null() const { return value_->kind == JsonKind::kNull; }

  // The same value. Refused: it is of another kind.
  const JsonCursor& object() const { return expect(JsonKind::kObject, "an object"); }
  const JsonCursor& array() const { return expect(JsonKind::kArray, "an array"); }
  /// Refused as well: it has another number of items. of_what names them in the message.
  const JsonCursor& array(size_t count, std::string_view of_what = "items") const;

  /// The member of this object, if there is one. Refused: it is no object.
  std::optional<JsonCursor> find(std::string_view key) const;
  /// The member of this object. Refused as well: it is missing; `why` ends that message.
  JsonCursor at(std::string_view key, std::string_view why = "") const;
  /// How many items this array has; item i.
  size_t size() const { return value_->items.size(); }
  JsonCursor item(size_t i) const;

  const std::string& string() const { return expect(JsonKind::kString, "a string").value_->text; }
  bool boolean() const { return expect(JsonKind::kBool, "true or false").value_->text == "true"; }
  /// A finite number that the text names exactly (parse_exact_real).
  double real() const;
  template <class Int>
  Int integer(Int least = std::numeric_limits<Int>::min(),
              Int most = std::numeric_limits<Int>::max()) const {
    const std::string& text = value_->text;
    const bool is_integer =
        value_->kind == JsonKind::kNumber && text.find_first_of(".eE") == std::string::npos;
    if (!is_integer) refuse_value("is not an integer");
    Int x{};
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), x);
    if (status != std::errc() || end != text.data() + text.size() || x < least || most < x) {
      refuse_value(fmt::format("is outside {}..{}", least, most));
    }
    return x;
  }

 private:
  JsonCursor(const JsonValue& value, const std::string* file, std::string path)
      : value_(&value), file_(file), path_(std::move(path)) {}
  const JsonCursor& expect(JsonKind kind, const char* name) const;

  const JsonValue* value_;
  const std::string* file_;
  std::string path_;
};

/// Gives read a cursor at the top of what the text of `file` holds. Errors: read refused a value.
template <class Read>
Result<void> read_json_tree(const JsonValue& value, const std::string& file, const Read& read) {
  try {
    read(JsonCursor(value, file));
  } catch (const JsonCursor::Refusal& refusal) {
    return tl::unexpected(refusal.error);
  }
  return {};
}

/// The same, of a text. Errors: it is no JSON, too.
template <class Read>
Result<void> read_json_text(std::string_view text, const std::string& file, const Read& read) {
  return parse_json(text, file).and_then([&](const JsonValue& value) {
    return read_json_tree(value, file, read);
  });
}

}  // namespace ccdfuzz
