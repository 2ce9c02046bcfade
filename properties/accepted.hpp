#pragma once

#include <fmt/format.h>

#include <string_view>

#include "case/case_json.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// Holds iff the checker's word is as expected; else says what it accepts or refuses, and of which
/// case.
inline Check accepted_iff(bool accepted, bool expected, std::string_view what, const Case& about) {
  if (accepted == expected) return Check::holds();
  return Check::fails(
      fmt::format("{} {}\n{}", accepted ? "accepts" : "refuses", what, to_json(about)));
}

}  // namespace ccdfuzz
