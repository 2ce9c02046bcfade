#include "cli/reproduction.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "finds/failure.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

std::string reproduction(const std::string& path, const std::map<std::string, Expected>& expect) {
  std::string methods, plugins;
  for (const auto& [method, expected] : expect) {
    if (!is_failure(expected.outcome)) continue;
    methods += (methods.empty() ? "" : ",") + method;
    if (const std::string spec = spec_behind(method); !spec.empty()) {
      plugins += fmt::format("{}{}={}", plugins.empty() ? "" : ",",
                             method.substr(method.find(':') + 1), spec);
    }
  }
  std::string command = fmt::format("{} query {}", shell_word(program_name()), shell_word(path));
  if (!plugins.empty()) command += " --plugin " + shell_word(plugins);
  return methods.empty() ? command : fmt::format("{} --methods {}", command, shell_word(methods));
}

}  // namespace ccdfuzz
