#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// Claims about one subject. A fuzz target of its name checks inputs against those that are thought
/// to hold (fuzz/suite.cpp). properties/CMakeLists.txt says which files it is made of.
struct Suite {
  std::string name;
  /// True if it has one claim, and each byte of its fuzz target's inputs is a choice of it. So a
  /// text that the claim draws is those bytes.
  bool is_of_bytes = false;
  std::vector<Property> claims;

  /// Those that are expected to hold, in the same order.
  std::vector<Property> thought_to_hold() const;
};

/// Every suite, as properties/CMakeLists.txt lists them.
const std::vector<Suite>& suites();

/// Errors: an unknown name, with those that there are.
Result<Suite> suite_named(std::string_view name);

/// The properties of all suites, for drivers and for `ccdfuzz properties`.
const std::vector<Property>& properties();

/// Errors: an unknown name, with those that are like it.
Result<Property> property_named(std::string_view name,
                                const std::vector<Property>& among = properties());

}  // namespace ccdfuzz
