#include "io/json_cursor.hpp"

#include "io/json_real.hpp"

namespace ccdfuzz {

void JsonCursor::refuse(std::string what) const {
  throw Refusal{{path_.empty() ? *file_ : fmt::format("{}: {}", *file_, path_), std::move(what)}};
}

void JsonCursor::refuse_below(const InputError& fault) const {
  const std::string path = path_.empty() ? fault.where : fmt::format("{}.{}", path_, fault.where);
  JsonCursor(*value_, file_, path).refuse(fault.what);
}

void JsonCursor::refuse_value(std::string_view why) const {
  refuse(fmt::format("{} {}", shown(*value_), why));
}

const JsonCursor& JsonCursor::expect(JsonKind kind, const char* name) const {
  if (value_->kind != kind) refuse_value(fmt::format("is not {}", name));
  return *this;
}

const JsonCursor& JsonCursor::array(size_t count, std::string_view of_what) const {
  array();
  if (size() != count) refuse(fmt::format("needs {} {}, not {}", count, of_what, size()));
  return *this;
}

std::optional<JsonCursor> JsonCursor::find(std::string_view key) const {
  const JsonValue* const found = object().value_->find(key);
  if (found == nullptr) return std::nullopt;
  return JsonCursor(*found, file_, member_path(path_, key));
}

JsonCursor JsonCursor::at(std::string_view key, std::string_view why) const {
  if (auto found = find(key)) return *std::move(found);
  throw Refusal{
      {fmt::format("{}: {}", *file_, member_path(path_, key)), fmt::format("missing{}", why)}};
}

JsonCursor JsonCursor::item(size_t i) const {
  return {value_->items[i], file_, fmt::format("{}[{}]", path_, i)};
}

double JsonCursor::real() const {
  const Result<double> x = parse_exact_real(*value_);
  if (!x) refuse(x.error().what);
  return *x;
}

}  // namespace ccdfuzz
