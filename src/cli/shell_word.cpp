#include "cli/shell_word.hpp"

#include <fmt/format.h>

#include "cli/command.hpp"
#include "corpus/store.hpp"

namespace ccdfuzz {

std::string shell_word(const std::string& text) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-+:,=@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) c == '\'' ? quoted += "'\\''" : quoted += c;
  return quoted + "'";
}

std::string reproduction(const std::string& path, const std::map<std::string, Outcome>& expect) {
  std::string methods;
  for (const auto& [method, outcome] : expect) {
    if (is_failure(outcome)) methods += (methods.empty() ? "" : ",") + method;
  }
  const std::string command =
      fmt::format("{} query {}", shell_word(program_name()), shell_word(path));
  return methods.empty() ? command : fmt::format("{} --methods {}", command, shell_word(methods));
}

}  // namespace ccdfuzz
