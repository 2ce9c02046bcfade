#include "cli/reproduction.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "finds/failure.hpp"
#include "method/method.hpp"
#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

namespace {

/// " OPTION VALUE,VALUE"; empty without values.
std::string option(const char* name, const std::vector<std::string>& values) {
  if (values.empty()) return "";
  return fmt::format(" {} {}", name, shell_word(fmt::format("{}", fmt::join(values, ","))));
}

/// --plugin for those that have a name.
std::string plugin_names(const std::vector<std::string>& methods) {
  std::vector<std::string> names;
  for (const std::string& method : methods) {
    if (const std::string spec = spec_behind(method); !spec.empty()) {
      names.push_back(method.substr(method.find(':') + 1) + "=" + spec);
    }
  }
  return option("--plugin", names);
}

}  // namespace

std::string reproduction(const std::string& path, const std::map<std::string, Expected>& expect) {
  std::vector<std::string> methods;
  for (const auto& [method, expected] : expect) {
    if (is_failure(expected.outcome)) methods.push_back(method);
  }
  return fmt::format("{} query {}{}{}", shell_word(program_name()), shell_word(path),
                     plugin_names(methods), option("--methods", methods));
}

std::string replay_command(const std::string& folder, std::vector<std::string> methods) {
  const std::string names = plugin_names(methods);
  std::erase_if(methods, [](const std::string& method) {
    return !names_plugin(method) || !spec_behind(method).empty();
  });
  return fmt::format("{} replay {}{}{}", shell_word(program_name()), shell_word(folder), names,
                     option("--allow-plugins", methods));
}

}  // namespace ccdfuzz
