#include "method/parameter.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace ccdfuzz {

namespace {

constexpr const char* kWhere = "--methods";

/// strtod alone would take leading blanks, signs, "nan" and "inf" as well.
bool starts_a_number(const std::string& text) {
  return !text.empty() && (text[0] == '.' || ('0' <= text[0] && text[0] <= '9'));
}

}  // namespace

SplitSpec split_spec(const std::string& spec) {
  const size_t colon = spec.find(':');
  if (colon == std::string::npos) return {spec, std::nullopt};
  return {spec.substr(0, colon), spec.substr(colon + 1)};
}

Result<double> parse_pull_apart(const std::string& spec) {
  const SplitSpec split = split_spec(spec);
  if (!split.argument || split.argument->empty()) {
    return input_error(
        kWhere, fmt::format("\"{}\" needs a pull-apart factor, as in {}:1e-12", spec, split.name));
  }
  const std::string& text = *split.argument;
  char* end = nullptr;
  const double value = starts_a_number(text) ? std::strtod(text.c_str(), &end) : -1.0;
  if (value < 0 || !std::isfinite(value) || end != text.c_str() + text.size()) {
    return input_error(kWhere, fmt::format("the pull-apart factor \"{}\" of \"{}\" is not a finite "
                                           "number ≥ 0",
                                           text, spec));
  }
  return value;
}

}  // namespace ccdfuzz
