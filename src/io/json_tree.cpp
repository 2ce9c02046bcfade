#include "io/json_tree.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/json_library.hpp"
#include "io/json_write.hpp"

namespace ccdfuzz {

namespace {

bool is_plain_word(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return c == '_' || c == '-' || (c < 128 && std::isalnum(c) != 0);
  });
}

/// Builds the tree from the library's events. The library's own tree would round numbers, drop the
/// sign of -0 and keep the last of two equal keys without a word.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  JsonValue root;
  InputError error;

  bool null() override { return scalar(JsonKind::kNull, "null"); }
  bool boolean(bool value) override { return scalar(JsonKind::kBool, value ? "true" : "false"); }
  bool number_unsigned(number_unsigned_t value) override {
    return scalar(JsonKind::kNumber, fmt::format("{}", value));
  }
  bool number_integer(number_integer_t value) override {
    // Only numbers with a minus come here, so that 0 is what is left of "-0".
    return scalar(JsonKind::kNumber, value == 0 ? "-0" : fmt::format("{}", value));
  }
  bool number_float(number_float_t, const string_t& token) override {
    std::string text = token;  // holds the locale's decimal point where the file has '.'
    for (char& c : text) {
      if (std::string_view("0123456789+-eE").find(c) == std::string_view::npos) c = '.';
    }
    return scalar(JsonKind::kNumber, std::move(text));
  }
  bool string(string_t& value) override { return scalar(JsonKind::kString, std::move(value)); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(JsonKind::kObject); }
  bool start_array(std::size_t) override { return open(JsonKind::kArray); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    std::vector<std::string>& keys = open_.back()->keys;
    if (std::find(keys.begin(), keys.end(), name) != keys.end()) {
      return refuse(member_path(path(open_.size()), name), "duplicate key");
    }
    if (keys.size() == kMaxJsonKeys) {
      return refuse(path(open_.size()), fmt::format("more than {} keys", kMaxJsonKeys));
    }
    keys.push_back(std::move(name));
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& e) override {
    if (e.id == 406) {  // a number past the largest double
      JsonValue& value = append(JsonKind::kNumber);
      value.text = token;
      return refuse(path(open_.size() + 1), shown(value) + " is out of the range of a double");
    }
    // "[json.exception.parse_error.101] parse error at line 1, column 2: what"
    const std::string_view full = e.what();
    const size_t colon = full.find(": ");
    const size_t before = std::min(position == 0 ? 0 : position - 1, text_.size());
    const std::string_view head = text_.substr(0, before);
    const size_t line_start = head.rfind('\n') == std::string_view::npos ? 0 : head.rfind('\n') + 1;
    std::string at = fmt::format("column {}", before - line_start + 1);
    if (text_.find('\n') != std::string_view::npos) {
      at = fmt::format("line {}, {}", 1 + std::count(head.begin(), head.end(), '\n'), at);
    }
    const bool is_json = head.find_first_not_of(" \t\r\n") != std::string_view::npos;
    error = {file_, fmt::format("{}: {}{}", at,
                                colon == std::string_view::npos ? full : full.substr(colon + 2),
                                is_json ? "" : "; JSON is accepted")};
    return false;
  }

 private:
  JsonValue& append(JsonKind kind) {
    JsonValue* value = &root;
    if (!open_.empty()) value = &open_.back()->items.emplace_back();
    value->kind = kind;
    return *value;
  }

  bool scalar(JsonKind kind, std::string text) {
    append(kind).text = std::move(text);
    return true;
  }

  bool open(JsonKind kind) {
    // A parent's items grow only once its last child is closed, so these pointers hold.
    open_.push_back(&append(kind));
    if (open_.size() <= kMaxJsonDepth) return true;
    error = {file_, fmt::format("nested deeper than {} levels", kMaxJsonDepth)};
    return false;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  /// The path of the last value at the given depth; 1 is the root.
  std::string path(size_t depth) const {
    std::string out;
    for (size_t d = 1; d < depth; ++d) {
      const JsonValue& container = *open_[d - 1];
      if (container.kind == JsonKind::kObject) {
        out = member_path(out, container.keys.back());
      } else {
        out += fmt::format("[{}]", container.items.size() - 1);
      }
    }
    return out;
  }

  bool refuse(const std::string& path, std::string what) {
    error = {path.empty() ? file_ : file_ + ": " + path, std::move(what)};
    return false;
  }

  std::string_view text_;
  const std::string& file_;
  std::vector<JsonValue*> open_;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  const auto at = std::find(keys.begin(), keys.end(), key);
  return at == keys.end() ? nullptr : &items[static_cast<size_t>(at - keys.begin())];
}

bool JsonValue::operator==(const JsonValue& other) const {
  if (kind != other.kind || text != other.text || items.size() != other.items.size()) return false;
  if (kind != JsonKind::kObject) return items == other.items;
  for (size_t i = 0; i < items.size(); ++i) {
    const JsonValue* const same = other.find(keys[i]);
    if (same == nullptr || !(*same == items[i])) return false;
  }
  return true;
}

Result<JsonValue> parse_json(std::string_view text, const std::string& file) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return input_error(file, "is empty; JSON is accepted");
  }
  TreeBuilder builder(text, file);
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) {
    return tl::unexpected(builder.error);
  }
  // The library takes a zero byte for the end of the text.
  if (const size_t zero = text.find('\0'); zero != std::string_view::npos) {
    return input_error(file, "byte {} is 0, which no JSON text has", zero + 1);
  }
  return std::move(builder.root);
}

std::string shown(const JsonValue& value) {
  constexpr size_t kLongest = 60;
  if (value.kind == JsonKind::kArray) return "an array";
  if (value.kind == JsonKind::kObject) return "an object";
  const std::string text = value.text.substr(0, kLongest);
  const char* const rest = value.text.size() > kLongest ? "…" : "";
  return (value.kind == JsonKind::kString ? json_string(text) : text) + rest;
}

std::string member_path(const std::string& path, std::string_view key) {
  if (!is_plain_word(key)) return fmt::format("{}[{}]", path, json_string(key));
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

}  // namespace ccdfuzz
