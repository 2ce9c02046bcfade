#include "fuzz/target.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <iostream>

#include "properties/registry.hpp"

namespace ccdfuzz {

namespace {

Property property_or_abort(std::string_view name) {
  const Result<Property> found = property_named(name);
  if (found) return *found;
  std::cerr << found.error().message() << '\n';
  std::abort();
}

int check_property_on(const Property& property, std::span<const std::uint8_t> bytes) {
  ByteChoices choices(bytes);
  const Check check = run(property, choices);
  if (check.status == Check::Status::kDiscarded) return -1;  // not for the corpus
  if (check.status == Check::Status::kFails) {
    std::cerr << fmt::format("{} fails: {}\nreproduce: {} {} --hex {}\n", property.name, check.text,
                             CCDFUZZ_CHECK_PROPERTY, property.name, to_hex_word(choices.bytes()));
    std::abort();
  }
  return 0;
}

}  // namespace

int check_bytes(std::string_view property, const std::uint8_t* data, std::size_t size) {
  static const Property target = property_or_abort(property);  // one target a process
  return check_property_on(target, {data, size});
}

int check_bytes_of_any(std::span<const std::string_view> properties, const std::uint8_t* data,
                       std::size_t size) {
  static const std::vector<Property> targets = [&] {
    std::vector<Property> found;
    for (const std::string_view name : properties) found.push_back(property_or_abort(name));
    return found;
  }();
  if (size == 0) return -1;
  return check_property_on(targets[data[0] % targets.size()], {data + 1, size - 1});
}

}  // namespace ccdfuzz
