#include "fuzz/target.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <iostream>

#include "properties/fuzz_targets.hpp"

namespace ccdfuzz {

int check_target(std::string_view target, std::span<const std::uint8_t> bytes) {
  static const FuzzTarget claims = fuzz_target_named(target).value();
  const auto input = claim_input(claims, bytes);
  if (!input) return -1;  // not for the corpus
  ByteChoices choices(input->bytes);
  const Check check = run(input->property, choices);
  if (check.status == Check::Status::kDiscarded) return -1;
  if (check.status == Check::Status::kFails) {
    std::cerr << fmt::format("{}: {} fails: {}\nreproduce: {} {} --hex {}\n", claims.find,
                             input->property.name, check.text, CCDFUZZ_CHECK_PROPERTY,
                             input->property.name, to_hex_word(choices.bytes()));
    std::abort();
  }
  return 0;
}

}  // namespace ccdfuzz
