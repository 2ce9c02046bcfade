#pragma once

#include <fmt/format.h>

#include <concepts>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "base/hex_bytes.hpp"
#include "files/case_json.hpp"
#include "generators/draw/draw.hpp"
#include "numeric/rational.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// What rows of claims say of them.
using enum Expectation;

/// Bytes that are shown as pairs of hex digits.
struct AsHex {
  std::string_view bytes;
};
inline std::string to_hex_text(const AsHex& text) {
  return to_hex_bytes(text.bytes);
}

/// The text of a value in a failure. Doubles are hex floats, cases and queries JSON. What the
/// project writes as text is that text. Sequences are the texts of their elements, and errors their
/// messages.
template <class T>
std::string shown(const T& value) {
  if constexpr (std::same_as<T, double>) {
    return to_hex(value);
  } else if constexpr (std::same_as<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_arithmetic_v<T>) {
    return fmt::format("{}", value);
  } else if constexpr (std::convertible_to<T, std::string_view>) {
    return std::string(std::string_view(value));
  } else if constexpr (std::same_as<T, Result<void>>) {
    return value ? "accepted" : value.error().message();
  } else if constexpr (requires { value.error().message(); }) {
    return value ? shown(*value) : value.error().message();
  } else if constexpr (requires { value.has_value(); }) {
    return value.has_value() ? shown(*value) : "none";
  } else if constexpr (requires { to_hex_text(value); }) {
    return to_hex_text(value);
  } else if constexpr (requires { to_text(value); }) {
    return to_text(value);
  } else if constexpr (requires { name_of(value); }) {
    return std::string(name_of(value));
  } else if constexpr (requires { value.rational(); }) {
    const auto same = value.to_double_exactly();
    return same ? shown(*same) : to_text(value.rational());
  } else if constexpr (std::ranges::range<const T>) {
    std::string text;
    for (const auto& element : value) text += (text.empty() ? "[" : ", ") + shown(element);
    return text.empty() ? "[]" : text + "]";
  } else {
    return to_json(value);
  }
}

/// Within a check: a value that a failure shows, one line each. Costs a branch otherwise. Returns
/// the value, so that what is drawn is named where it is drawn.
template <class T>
T&& show(Draw& draw, std::string_view name, T&& value) {
  if (std::string* story = draw.story()) *story += fmt::format("\n  {} = {}", name, shown(value));
  return std::forward<T>(value);
}

}  // namespace ccdfuzz
