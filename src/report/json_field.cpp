#include "report/json_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace ccdfuzz {

void JsonField::refuse(const std::string& why) const {
  const std::string where = path_.empty() ? *file_ : fmt::format("{}: {}", *file_, path_);
  throw Refusal{{where, fmt::format("{} {}", shown(*value_), why)}};
}

JsonField JsonField::operator[](const char* key) const {
  const auto found = find(key);
  if (!found) refuse(fmt::format("has no \"{}\"", key));
  return *found;
}

std::optional<JsonField> JsonField::find(const char* key) const {
  if (value_->kind != JsonKind::kObject) refuse("is not an object");
  const JsonValue* const found = value_->find(key);
  if (!found) return std::nullopt;
  return JsonField(*found, *file_, member_path(path_, key));
}

void JsonField::expect_only(std::initializer_list<std::string_view> keys) const {
  if (value_->kind != JsonKind::kObject) refuse("is not an object");
  for (const std::string& key : value_->keys) {
    if (std::ranges::find(keys, key) == keys.end()) (*this)[key.c_str()].refuse("is unknown");
  }
}

std::vector<JsonField> JsonField::items() const {
  if (value_->kind != JsonKind::kArray) refuse("is not an array");
  std::vector<JsonField> all;
  for (const JsonValue& item : value_->items) {
    all.emplace_back(item, *file_, fmt::format("{}[{}]", path_, all.size()));
  }
  return all;
}

const std::string& JsonField::text() const {
  if (value_->kind != JsonKind::kString) refuse("is not a string");
  return value_->text;
}

bool JsonField::truth() const {
  if (value_->kind != JsonKind::kBool) refuse("is neither true nor false");
  return value_->text == "true";
}

std::uint64_t JsonField::count() const {
  const std::string& digits = value_->text;
  std::uint64_t x = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), x);
  if (value_->kind != JsonKind::kNumber || status != std::errc() ||
      end != digits.data() + digits.size()) {
    refuse("is not a whole number from 0 on");
  }
  return x;
}

double JsonField::amount() const {
  if (value_->kind != JsonKind::kNumber) refuse("is not a number");
  const Result<double> x = parse_real(*value_);
  if (!x) refuse(x.error().what);
  if (*x < 0) refuse("is negative");
  return *x;
}

void expect_format(const JsonField& object, const std::string& format) {
  if (object["format"].text() != format) {
    object["format"].refuse(fmt::format("is not \"{}\"", format));
  }
  if (object["version"].count() != 1) object["version"].refuse("is not the version 1");
}

}  // namespace ccdfuzz
