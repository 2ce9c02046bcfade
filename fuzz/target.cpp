#include "fuzz/target.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <iostream>

#include "properties/registry.hpp"

namespace ccdfuzz {

int check_bytes(std::string_view property, const std::uint8_t* data, std::size_t size) {
  static const Result<Property> target = property_named(property);  // one target a process
  if (!target) {
    std::cerr << target.error().message() << '\n';
    std::abort();
  }
  ByteChoices choices(std::span(data, size));
  const Check check = run(*target, choices);
  if (check.status == Check::Status::kDiscarded) return -1;  // not for the corpus
  if (check.status == Check::Status::kFails) {
    std::cerr << fmt::format("{} fails: {}\nreproduce: {} {} --hex {}\n", property, check.text,
                             CCDFUZZ_CHECK_PROPERTY, property, to_hex_bytes(choices.bytes()));
    std::abort();
  }
  return 0;
}

}  // namespace ccdfuzz
