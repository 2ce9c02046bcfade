#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "properties/suites.hpp"

namespace ccdfuzz {

/// An input of a suite's fuzz target: one of its claims, and choices for it.
struct ClaimInput {
  Property property;
  ChoiceNumbers choices;
};

/// The first kClaimHead bytes say which claim: hex digits of its name's hash, so that inputs keep
/// their meaning when claims are added. The choices follow (choice_bytes.hpp). In a suite
/// of bytes (is_of_bytes) each byte is a choice, and there is no head. None for the hash of no
/// claim that is thought to hold.
std::optional<ClaimInput> claim_input(const Suite& suite, std::span<const std::uint8_t> bytes);
inline constexpr std::size_t kClaimHead = 8;

/// The head and the choices of an input.
std::vector<std::uint8_t> to_bytes(const ClaimInput& input);

}  // namespace ccdfuzz
