#include "method/plugin/plugin_spec.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <type_traits>

#include "base/read_double.hpp"

namespace ccdfuzz {

namespace {

tl::unexpected<InputError> bad_spec(const std::string& spec, const std::string& why) {
  return input_error("--methods", fmt::format("\"{}\": {}", spec, why));
}

/// A number in [least, most] that is all of the text.
template <class Number>
std::optional<Number> number_in(const std::string& text, Number least, Number most) {
  Number value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, status] = [&] {
    if constexpr (std::is_floating_point_v<Number>) {
      return read_double(text.data(), last, value);
    } else {
      return std::from_chars(text.data(), last, value);
    }
  }();
  const bool whole = status == std::errc() && end == text.data() + text.size();
  return whole && least <= value && value <= most ? std::optional(value) : std::nullopt;
}

/// Takes an option that is the host's own. False: it is the plug-in's. Errors: its value.
Result<bool> take_host_option(const std::string& option, PluginSpec& spec) {
  const size_t equals = std::min(option.find('='), option.size());
  const std::string key = option.substr(0, equals);
  const std::string value = equals < option.size() ? option.substr(equals + 1) : "";
  if (key == "seconds") {
    const auto seconds = number_in(value, 1e-3, 86400.0);
    if (!seconds) return bad_spec(spec.text, "seconds=" + value + " is not in [0.001, 86400]");
    spec.seconds = *seconds;
  } else if (key == "mb") {
    const auto megabytes = number_in<std::uint64_t>(value, 16, 1 << 20);
    if (!megabytes) return bad_spec(spec.text, "mb=" + value + " is not in [16, 1048576]");
    spec.megabytes = *megabytes;
  } else if (key == "repeat") {
    if (value != "yes" && value != "no") {
      return bad_spec(spec.text, "repeat=" + value + " is neither yes nor no");
    }
    spec.repeats = value == "yes";
  } else {
    return false;
  }
  return true;
}

}  // namespace

bool names_plugin(const std::string& spec) {
  return spec.starts_with(kPluginPrefix) || spec.starts_with(kPluginProgramPrefix);
}

bool is_plugin_name(const std::string& spec) {
  return spec.starts_with(kPluginPrefix) &&
         spec.find_first_of("/.:", std::string(kPluginPrefix).size()) == std::string::npos;
}

Result<PluginSpec> parse_plugin_spec(const std::string& spec) {
  PluginSpec parsed;
  parsed.text = spec;
  parsed.is_program = spec.starts_with(kPluginProgramPrefix);
  const size_t path_at = spec.find(':') + 1;
  const size_t path_end = std::min(spec.find(':', path_at), spec.size());
  parsed.path = spec.substr(path_at, path_end - path_at);
  if (parsed.path.empty()) return bad_spec(spec, "names no file");
  if (is_plugin_name(spec)) {
    return bad_spec(spec, "is a name: --plugin NAME=SPEC says what stands behind it");
  }
  std::error_code error;
  if (!std::filesystem::exists(parsed.path, error)) return bad_spec(spec, "no such file");
  if (!std::filesystem::is_regular_file(parsed.path, error)) return bad_spec(spec, "is no file");
  if (parsed.path.find('/') == std::string::npos) parsed.path.insert(0, "./");

  for (size_t begin = path_end + 1; begin <= spec.size();) {
    const size_t end = std::min(spec.find(':', begin), spec.size());
    const std::string option = spec.substr(begin, end - begin);
    CCDFUZZ_TRY(const bool taken, take_host_option(option, parsed));
    if (!taken) parsed.options += (parsed.options.empty() ? "" : ":") + option;
    begin = end + 1;
  }
  return parsed;
}

}  // namespace ccdfuzz
