#include "method/plugin/plugin_spec.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/number_text.hpp"
#include "base/text.hpp"

namespace ccdfuzz {

namespace {

tl::unexpected<InputError> bad_spec(const std::string& spec, const std::string& why) {
  return input_error("method", "\"{}\": {}", spec, why);
}

/// Takes an option that is the host's own. False: it is the plug-in's. Errors: its value.
Result<bool> take_host_option(const std::string& option, PluginSpec& spec) {
  const size_t equals = std::min(option.find('='), option.size());
  const std::string key = option.substr(0, equals);
  const std::string value = equals < option.size() ? option.substr(equals + 1) : "";
  if (key == "seconds") {
    const Result<double> seconds = parse_number("", value);
    if (!seconds || *seconds < 1e-3 || *seconds > 86400) {
      return bad_spec(spec.text, "seconds=" + value + " is not in [0.001, 86400]");
    }
    spec.seconds = *seconds;
  } else if (key == "mb") {
    const Result<std::uint64_t> megabytes = parse_whole("", value);
    if (!megabytes || *megabytes < 16 || *megabytes > 1 << 20) {
      return bad_spec(spec.text, "mb=" + value + " is not in [16, 1048576]");
    }
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
  const std::vector<std::string> parts = texts_between(spec, ':');
  parsed.path = parts.at(1);
  if (parsed.path.empty()) return bad_spec(spec, "names no file");
  if (is_plugin_name(spec)) {
    return bad_spec(spec, "is a name: --plugin NAME=SPEC says what stands behind it");
  }
  std::error_code error;
  if (!std::filesystem::exists(parsed.path, error)) return bad_spec(spec, "no such file");
  if (!std::filesystem::is_regular_file(parsed.path, error)) return bad_spec(spec, "is no file");
  if (parsed.is_program && parsed.path.ends_with(".so")) {
    return bad_spec(spec, fmt::format("is a library, not a program: {}{}", kPluginPrefix,
                                      spec.substr(std::string(kPluginProgramPrefix).size())));
  }
  if (parsed.path.find('/') == std::string::npos) parsed.path.insert(0, "./");

  for (size_t i = 2; i < parts.size(); ++i) {
    CCDFUZZ_TRY(const bool taken, take_host_option(parts[i], parsed));
    if (!taken) parsed.options += (parsed.options.empty() ? "" : ":") + parts[i];
  }
  return parsed;
}

}  // namespace ccdfuzz
