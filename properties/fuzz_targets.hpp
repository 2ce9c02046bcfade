#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// A libFuzzer target that puts its bytes to claims (fuzz/NAME.cpp).
struct FuzzTarget {
  std::string_view name;
  std::string_view find;  ///< what a counterexample to one of them is: "refuted bound"
  std::vector<Property> claims;
};

/// The names of all.
std::vector<std::string_view> fuzz_targets();

/// Errors: an unknown name, with those that there are; a claim that is no property.
Result<FuzzTarget> fuzz_target_named(std::string_view name);

/// What an input of a target is: one of its claims, and the bytes that are put to it (ByteChoices).
struct ClaimInput {
  Property property;
  std::span<const std::uint8_t> bytes;
};

/// Of several claims the first byte says which; without it there is none.
std::optional<ClaimInput> claim_input(const FuzzTarget& target,
                                      std::span<const std::uint8_t> bytes);

}  // namespace ccdfuzz
