#pragma once

#include <fmt/ranges.h>

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ccdfuzz {

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
  std::vector<std::string_view> names;
  for (const E e : all_of(E{})) names.push_back(name_of(e));
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace ccdfuzz
