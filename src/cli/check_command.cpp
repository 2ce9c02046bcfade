#include "cli/check_command.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "generators/draw/choice_bytes.hpp"

namespace ccdfuzz {

std::string check_command(const std::string& property, const std::string& method,
                          const std::string& on) {
  const std::string words = method.empty() ? "" : method_words(std::vector<std::string>{method});
  return fmt::format("{} check {}{} {}", shell_word(program_name()), property, words, on);
}

std::string words_of(const ChoiceNumbers& choices) {
  return "--choices " + to_word(choices);
}

std::string words_of(std::uint64_t seed, std::uint64_t index) {
  return fmt::format("--seed {} --first {} --count 1", seed, index);
}

std::string reproduction(const ClaimFind& find) {
  return find.shrunk == Shrunk::kNot
             ? find.as_found
             : check_command(find.property, find.method, words_of(find.choices));
}

}  // namespace ccdfuzz
