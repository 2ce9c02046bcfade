#include "cli/reproduction.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "finds/store.hpp"

namespace ccdfuzz {

std::string reproduction(const std::string& path, const std::map<std::string, Expected>& expect) {
  std::string methods;
  for (const auto& [method, expected] : expect) {
    if (is_failure(expected.outcome)) methods += (methods.empty() ? "" : ",") + method;
  }
  const std::string command =
      fmt::format("{} query {}", shell_word(program_name()), shell_word(path));
  return methods.empty() ? command : fmt::format("{} --methods {}", command, shell_word(methods));
}

}  // namespace ccdfuzz
