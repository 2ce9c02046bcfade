#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace ccdfuzz {

// An enumeration with the values 0, 1, … names them once, beside itself:
//
//   enum class Verdict : std::uint8_t { kHit, kMiss };
//   constexpr std::array<std::string_view, 2> names_of(Verdict) { return {"hit", "miss"}; }

template <class E>
concept HasNames = requires(E e) {
  names_of(e);
};

template <HasNames E>
constexpr std::string_view name_of(E value) {
  return names_of(value).at(static_cast<std::size_t>(value));
}

/// All values, in their order.
template <HasNames E>
constexpr auto all_of(E) {
  std::array<E, names_of(E{}).size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<E>(i);
  return all;
}

/// An enumeration whose values have names: name_of(e), and all of which all_of(e) lists.
template <class E>
concept NamedEnum = std::is_enum_v<E> && requires(E e) {
  name_of(e);
  all_of(e);
};

/// The value whose name the text is, if there is one.
template <NamedEnum E>
std::optional<E> enum_named(std::string_view text) {
  for (const E e : all_of(E{})) {
    if (name_of(e) == text) return e;
  }
  return std::nullopt;
}

/// "a, b, c": the names of all values.
template <NamedEnum E>
std::string enum_names() {
  std::string names;
  for (const E e : all_of(E{})) names.append(names.empty() ? "" : ", ").append(name_of(e));
  return names;
}

}  // namespace ccdfuzz
