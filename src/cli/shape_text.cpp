#include "cli/shape_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace ccdfuzz {

namespace {

/// The degree that the text is all of.
std::optional<int> degree_of(std::string_view text) {
  int degree = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, degree);
  if (error != std::errc() || stop != end) return std::nullopt;
  return degree;
}

std::optional<Shape> shape_of(std::string_view text) {
  if (text == "point") return Shape::point();
  const size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::string_view kind = text.substr(0, colon), degrees = text.substr(colon + 1);
  if (kind == "tensor") {
    const size_t x = degrees.find('x');
    if (x == std::string_view::npos) return std::nullopt;
    const auto n = degree_of(degrees.substr(0, x)), m = degree_of(degrees.substr(x + 1));
    if (!n || !m) return std::nullopt;
    return Shape::tensor(*n, *m);
  }
  const auto n = degree_of(degrees);
  if (!n) return std::nullopt;
  if (kind == "curve") return Shape::curve(*n);
  if (kind == "triangle") return Shape::triangle(*n);
  return std::nullopt;
}

Result<Shape> parse_shape(const std::string& where, std::string_view text) {
  const std::optional<Shape> shape = shape_of(text);
  if (!shape) {
    return input_error(where,
                       fmt::format("\"{}\" is not point, curve:N, triangle:N or tensor:NxM", text));
  }
  if (!shape->valid()) {
    return input_error(where, fmt::format("{} has a degree outside 1..{}", text, kMaxDegree));
  }
  return *shape;
}

}  // namespace

Result<std::array<Shape, 2>> parse_shapes(const std::string& where, const std::string& text) {
  const size_t comma = text.find(',');
  const Result<Shape> first = parse_shape(where, text.substr(0, comma));
  if (!first) return tl::unexpected(first.error());
  if (comma == std::string::npos) return std::array{*first, *first};
  const Result<Shape> second = parse_shape(where, text.substr(comma + 1));
  if (!second) return tl::unexpected(second.error());
  return std::array{*first, *second};
}

}  // namespace ccdfuzz
