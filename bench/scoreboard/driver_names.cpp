#include <fmt/format.h>

#include <algorithm>

#include "drivers.hpp"

namespace ccdfuzz {

Result<Driver> driver_named(std::string_view name) {
  const auto found = std::ranges::find(kDrivers, name, [](Driver d) { return name_of(d); });
  if (found != kDrivers.end()) return *found;
  std::string names;
  for (const Driver driver : kDrivers) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", name_of(driver));
  }
  return input_error("", fmt::format("no driver \"{}\"; there are: {}", name, names));
}

}  // namespace ccdfuzz
