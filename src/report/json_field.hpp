#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "query/json_tree.hpp"

namespace ccdfuzz {

/// A value in a JSON text and its path there. What is not as asked is thrown as a Refusal that
/// names file, path and value; catch it where the file is read (read_fields).
class JsonField {
 public:
  struct Refusal {
    InputError error;
  };

  JsonField(const JsonValue& value, const std::string& file, std::string path = "")
      : value_(&value), file_(&file), path_(std::move(path)) {}

  /// The member of this object. Refused: it is no object, or has no such member.
  JsonField operator[](const char* key) const;
  /// The same where it may be missing.
  std::optional<JsonField> find(const char* key) const;
  /// Refused: a member of this object that is none of these.
  void expect_only(std::initializer_list<std::string_view> keys) const;
  /// The items of this array.
  std::vector<JsonField> items() const;
  bool is_null() const { return value_->kind == JsonKind::kNull; }
  const std::string& text() const;
  bool truth() const;
  /// A whole number from 0 on.
  std::uint64_t count() const;
  /// A finite number from 0 on.
  double amount() const;
  [[noreturn]] void refuse(const std::string& why) const;

 private:
  const JsonValue* value_;
  const std::string* file_;
  std::string path_;
};

/// Parses the text of `file` and gives it to read(JsonField). Errors: it is no JSON, or read
/// refused a value of it; naming the file, and the value's path.
template <class Read>
Result<void> read_fields(std::string_view text, const std::string& file, const Read& read) {
  const Result<JsonValue> value = parse_json(text, file);
  if (!value) return tl::unexpected(value.error());
  try {
    read(JsonField(*value, file));
  } catch (const JsonField::Refusal& refusal) {
    return tl::unexpected(refusal.error);
  }
  return {};
}

/// Refused: the object is not of this format, of version 1.
void expect_format(const JsonField& object, const std::string& format);

}  // namespace ccdfuzz
