#include "method/parameter.hpp"

#include <fmt/format.h>

#include <cctype>

#include "base/read_double.hpp"

namespace ccdfuzz {

namespace {

constexpr const char* kWhere = "--methods";

/// from_chars alone would take "-1", "nan" and "inf" as well.
bool starts_a_number(const std::string& text) {
  return !text.empty() &&
         (text[0] == '.' || std::isxdigit(static_cast<unsigned char>(text[0])) != 0);
}

}  // namespace

SplitSpec split_spec(const std::string& spec) {
  const size_t colon = spec.find(':');
  if (colon == std::string::npos) return {spec, std::nullopt};
  return {spec.substr(0, colon), spec.substr(colon + 1)};
}

SwitchedSpec split_switches(const std::string& spec) {
  SwitchedSpec out{spec.substr(0, spec.find('@')), {}};
  for (size_t at = out.spec.size(); at < spec.size();) {
    const size_t end = std::min(spec.find('@', at + 1), spec.size());
    out.switches.push_back(spec.substr(at + 1, end - at - 1));
    at = end;
  }
  return out;
}

Result<double> parse_pull_apart(const std::string& spec) {
  const SplitSpec split = split_spec(spec);
  if (!split.argument || split.argument->empty()) {
    return input_error(
        kWhere, fmt::format("\"{}\" needs a pull-apart factor, as in {}:1e-12", spec, split.name));
  }
  const std::string& text = *split.argument;
  double value = 0;
  const char* const end = text.data() + text.size();
  const bool hex = text.starts_with("0x");
  const auto [rest, status] = read_double(text.data() + (hex ? 2 : 0), end, value, hex);
  if (!starts_a_number(hex ? text.substr(2) : text) || status != std::errc() || rest != end) {
    return input_error(kWhere, fmt::format("the pull-apart factor \"{}\" of \"{}\" is not a "
                                           "number ≥ 0 that a double holds",
                                           text, spec));
  }
  return value;
}

}  // namespace ccdfuzz
