#pragma once
// A record names its fields once:
//
//   struct Answered {
//     std::string id;
//     std::optional<double> toi;
//
//     static void fields(auto& archive, auto& answered) {
//       archive("case", answered.id);
//       archive("toi", answered.toi);
//     }
//   };
//
// JSON out and in follow from that: to_json, from_json. Fields may be numbers, texts, truths and
// records, and optionals, vectors, arrays and maps of these. A vector of pairs of a text and a
// value is a map in its own order. They may also be enumerations that have name_of(E) and
// all_of(E), and types with a JsonForm. What is only written need not be a record: a function of an
// archive does, such as [&](auto& archive) { archive("case", id); }.

#include <algorithm>
#include <array>
#include <concepts>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/ranges.h>

#include "base/double_parts.hpp"
#include "base/enum_names.hpp"
#include "io/json_cursor.hpp"
#include "io/json_write.hpp"

namespace ccdfuzz {

/// Specialise for a type that does not know its form in files. It has `fields` as above. What is no
/// record has static void write(std::string& json, const T&) and static void read(const
/// JsonCursor&, T&) instead.
template <class T>
struct JsonForm;

namespace fields_detail {
/// For the concepts: `fields` may be any function of an archive.
struct AnyArchive {};
}  // namespace fields_detail

/// True iff the archive, which may be a reference, reads.
template <class Archive>
inline constexpr bool kReads = std::remove_reference_t<Archive>::kReads;

template <class T>
concept HasOwnFields = requires(fields_detail::AnyArchive& archive, T& record) {
  T::fields(archive, record);
};
template <class T>
concept HasFields = HasOwnFields<T> || requires(fields_detail::AnyArchive& archive, T& record) {
  JsonForm<T>::fields(archive, record);
};

/// Hands all fields of a record, which may be const, to the archive.
template <class Archive, class T>
requires HasFields<std::remove_const_t<T>>
void visit_fields(Archive& archive, T& record) {
  if constexpr (HasOwnFields<std::remove_const_t<T>>) {
    T::fields(archive, record);
  } else {
    JsonForm<std::remove_const_t<T>>::fields(archive, record);
  }
}
template <class T>
concept HasJsonForm = requires(std::string& json, const T& value) {
  JsonForm<T>::write(json, value);
};
template <class T>
void write_json(std::string& json, const T& value);
template <class T>
void read_json(const JsonCursor& from, T& value);

// What a field may be held to when it is read: a function of the value, which returns what is
// wrong with it, or nothing.

/// From least to most, both included.
template <class T>
struct Within {
  T least, most;
  std::string operator()(const T& value) const {
    return least <= value && value <= most ? "" : fmt::format("is outside {}..{}", least, most);
  }
};
template <class T>
Within(T, T) -> Within<T>;
inline std::string not_negative(double value) {
  return compare(value, 0) < 0 ? "is negative" : "";
}
inline std::string positive(double value) {
  return compare(value, 0) > 0 ? "" : "is not > 0";
}
/// The check of each item of an array.
template <class Check>
struct Each {
  Check check;
};
template <class Check>
Each(Check) -> Each<Check>;

/// JSON text, written unchanged. Not read back.
struct RawJson {
  std::string_view text;
};

/// An archive that appends an object's members to a JSON text.
class JsonWriter {
 public:
  static constexpr bool kReads = false;

  explicit JsonWriter(std::string& json) : json_(json) {}

  /// A field that is always there.
  template <class T, class... Checks>
  void operator()(std::string_view name, const T& value, const Checks&...) {
    if (!first_) json_ += ',';
    first_ = false;
    json_ += json_string(name);
    json_ += ':';
    write_json(json_, value);
  }
  /// A field that is left out where it has its default.
  template <class T, class... Checks>
  void optional(std::string_view name, const T& value, const std::type_identity_t<T>& standard = {},
                const Checks&...) {
    when(!(value == standard), name, value);
  }
  /// A field that is left out unless `present`.
  template <class T, class... Checks>
  void when(bool present, std::string_view name, const T& value, const Checks&...) {
    if (present) (*this)(name, value);
  }
  /// Members that are no fields: name → JSON text.
  void others(const std::map<std::string, std::string>& members) {
    for (const auto& [name, text] : members) (*this)(name, RawJson{text});
  }
  /// A field that says what the record is.
  void constant(std::string_view name, std::string_view text) { (*this)(name, text); }
  /// The kind of the text, in its first two fields; returns the version.
  int format(std::string_view name, int, int version) {
    constant("format", name);
    (*this)("version", version);
    return version;
  }

 private:
  std::string& json_;
  bool first_ = true;
};

/// How a reader treats a member that the record does not name.
enum class Unknown { kRefuse, kIgnore };

/// An archive that reads an object's members. Refused: see JsonCursor.
class JsonReader {
 public:
  static constexpr bool kReads = true;

  explicit JsonReader(const JsonCursor& object) : object_(object.object()) {}

  template <class T, class... Checks>
  void operator()(std::string_view name, T& value, const Checks&... checks) {
    known_.push_back(name);
    take(object_.at(name), value, checks...);
  }
  /// A field that may be missing, and then keeps what the record has.
  template <class T, class... Checks>
  void optional(std::string_view name, T& value, const std::type_identity_t<T>& = {},
                const Checks&... checks) {
    when(true, name, value, checks...);
  }
  template <class T, class... Checks>
  void when(bool, std::string_view name, T& value, const Checks&... checks) {
    known_.push_back(name);
    if (const auto found = object_.find(name)) take(*found, value, checks...);
  }
  /// The members that no field was named for. Refused: one that is neither a text nor a number.
  void others(std::map<std::string, std::string>& members) {
    for (const std::string& key : object_.value().keys) {
      if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
      const JsonCursor member = object_.at(key);
      const JsonKind kind = member.value().kind;
      if (kind != JsonKind::kNumber && kind != JsonKind::kString) {
        member.refuse_value("is neither a string nor a number");
      }
      const std::string& text = member.value().text;
      members[key] = kind == JsonKind::kNumber ? text : json_string(text);
      known_.push_back(key);
    }
  }
  /// Refused: another text.
  void constant(std::string_view name, std::string_view text) {
    std::string found;
    (*this)(name, found, [&](const std::string& word) {
      return word == text ? "" : fmt::format("is not \"{}\"", text);
    });
  }
  /// Refused: another name, or a version that is not from least to most.
  int format(std::string_view name, int least, int most) {
    int version = 0;
    constant("format", name);
    (*this)("version", version, [&](int v) {
      if (least <= v && v <= most) return std::string();
      return least == most
                 ? fmt::format("is not a version that this program reads ({})", most)
                 : fmt::format("is not a version that this program reads ({} to {})", least, most);
    });
    return version;
  }

  const JsonCursor& object() const { return object_; }
  /// Refused: a member that no field was named for.
  void refuse_others() const {
    for (const std::string& key : object_.value().keys) {
      if (std::find(known_.begin(), known_.end(), key) == known_.end()) {
        object_.at(key).refuse(
            fmt::format("unknown key (known here: {})", fmt::join(known_, ", ")));
      }
    }
  }

 private:
  template <class T, class... Checks>
  void take(const JsonCursor& from, T& value, const Checks&... checks) {
    (hold_range(from, checks), ...);
    read_json(from, value);
    (hold(from, value, checks), ...);
  }
  /// The range of a field, which a whole number may leave that has no place in the field's type.
  template <std::integral Int>
  static void hold_range(const JsonCursor& from, const Within<Int>& range) {
    from.integer(range.least, range.most);
  }
  template <class Check>
  static void hold_range(const JsonCursor& from, const Each<Check>& each) {
    for (size_t i = 0; i < from.array().size(); ++i) hold_range(from.item(i), each.check);
  }
  static void hold_range(const JsonCursor&, const auto&) {}
  template <class T, class Check>
  static void hold(const JsonCursor& from, const T& value, const Check& check) {
    const std::string wrong = check(value);
    if (wrong.empty()) return;
    const JsonKind kind = from.value().kind;
    const bool is_container = kind == JsonKind::kArray || kind == JsonKind::kObject;
    is_container ? from.refuse(wrong) : from.refuse_value(wrong);
  }
  template <class T, class Check>
  static void hold(const JsonCursor& from, const T& value, const Each<Check>& each) {
    for (size_t i = 0; i < value.size(); ++i) hold(from.item(i), value[i], each.check);
  }

  JsonCursor object_;
  std::vector<std::string_view> known_;
};

namespace fields_detail {

/// Whether T is an instance of the template.
template <class T, template <class...> class Of>
inline constexpr bool kIs = false;
template <class... A, template <class...> class Of>
inline constexpr bool kIs<Of<A...>, Of> = true;
template <class T>
inline constexpr bool kIsArray = false;
template <class T, size_t N>
inline constexpr bool kIsArray<std::array<T, N>> = true;
template <class T>
inline constexpr bool kIsMap = false;
template <class T>
inline constexpr bool kIsMap<std::map<std::string, T>> = true;
template <class T>
inline constexpr bool kIsMap<std::vector<std::pair<std::string, T>>> = true;

template <class Items>
void write_items(std::string& json, const Items& items) {
  json += '[';
  for (const auto& item : items) {
    if (&item != &items[0]) json += ',';
    write_json(json, item);
  }
  json += ']';
}

template <HasFields T>
void read_record(const JsonCursor& from, T& record, Unknown unknown) {
  JsonReader reader(from);
  visit_fields(reader, record);
  if (unknown == Unknown::kRefuse) reader.refuse_others();
}

}  // namespace fields_detail

template <class T>
void write_json(std::string& json, const T& value) {
  using namespace fields_detail;
  if constexpr (HasJsonForm<T>) {
    JsonForm<T>::write(json, value);
  } else if constexpr (HasFields<T> || kIsMap<T> || std::invocable<const T&, JsonWriter&>) {
    json += '{';
    JsonWriter writer(json);
    if constexpr (HasFields<T>) {
      visit_fields(writer, value);
    } else if constexpr (kIsMap<T>) {
      for (const auto& [key, item] : value) writer(key, item);
    } else {
      value(writer);
    }
    json += '}';
  } else if constexpr (kIs<T, std::optional>) {
    value ? write_json(json, *value) : static_cast<void>(json += "null");
  } else if constexpr (kIs<T, std::vector> || kIsArray<T>) {
    write_items(json, value);
  } else if constexpr (std::same_as<T, RawJson>) {
    json += value.text;
  } else if constexpr (NamedEnum<T>) {
    json += json_string(name_of(value));
  } else if constexpr (std::same_as<T, bool>) {
    json += value ? "true" : "false";
  } else if constexpr (std::integral<T>) {
    json += fmt::format("{}", value);
  } else if constexpr (std::floating_point<T>) {
    is_finite(value) ? json += json_number(value) : json += "null";
  } else {
    json += json_string(value);
  }
}

template <class T>
void read_json(const JsonCursor& from, T& value) {
  using namespace fields_detail;
  if constexpr (HasJsonForm<T>) {
    JsonForm<T>::read(from, value);
  } else if constexpr (HasFields<T>) {
    read_record(from, value, Unknown::kRefuse);
  } else if constexpr (kIs<T, std::optional>) {
    if (from.is_null()) return value.reset();
    read_json(from, value.emplace());
  } else if constexpr (kIsMap<T>) {
    value.clear();
    for (const std::string& key : from.object().value().keys) {
      read_json(from.at(key), value.insert(value.end(), {key, {}})->second);
    }
  } else if constexpr (kIs<T, std::vector>) {
    value.clear();
    for (size_t i = 0; i < from.array().size(); ++i) read_json(from.item(i), value.emplace_back());
  } else if constexpr (kIsArray<T>) {
    from.array(value.size());
    for (size_t i = 0; i < value.size(); ++i) read_json(from.item(i), value[i]);
  } else if constexpr (NamedEnum<T>) {
    const auto named = enum_named<T>(from.string());
    if (!named) from.refuse_value(fmt::format("is none of {}", enum_names<T>()));
    value = *named;
  } else if constexpr (std::same_as<T, bool>) {
    value = from.boolean();
  } else if constexpr (std::integral<T>) {
    value = from.integer<T>();
  } else if constexpr (std::floating_point<T>) {
    value = from.real();
  } else {
    value = from.string();
  }
}

/// The value at the cursor.
template <class T>
T read_json(const JsonCursor& from) {
  T value;
  read_json(from, value);
  return value;
}

/// The value as JSON on one line, without its end. A number that is not finite is null.
template <class T>
std::string to_json(const T& value) {
  std::string json;
  write_json(json, value);
  return json;
}

/// The record in a JSON text. Errors: it is none; naming `file`, the path and the value.
template <HasFields T>
Result<T> from_json(std::string_view text, const std::string& file,
                    Unknown unknown = Unknown::kRefuse) {
  T record;
  return read_json_text(
             text, file,
             [&](const JsonCursor& top) { fields_detail::read_record(top, record, unknown); })
      .map([&] { return std::move(record); });
}

}  // namespace ccdfuzz
