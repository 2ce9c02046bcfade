#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "properties/suites.hpp"

namespace ccdfuzz {

/// What an input of a suite's fuzz target is: one of its claims, and where the choices come from
/// that it is put to: bytes, or draws.
struct ClaimInput {
  Property property;
  std::span<const std::uint8_t> bytes;
  std::optional<std::uint64_t> seed;  ///< of draws, in place of bytes

  Draw choices() const;
};

/// The same draws as those of `ccdfuzz check --seed S --first 0 --count 1`.
Draw draws_of(std::uint64_t seed);

/// Where a suite reads a text, the bytes are that. Any other's first byte says which claim, in its
/// lower bits, and by the highest whether the next eight are a seed, the lowest first. None without
/// the first byte.
std::optional<ClaimInput> claim_input(const Suite& suite, std::span<const std::uint8_t> bytes);

/// A draw of any claim as an input of a suite that reads no text.
std::vector<std::uint8_t> drawn_input(Draw& random);
/// The same choices as bytes, which can be changed one by one, where the input is one of draws.
/// Runs the claim.
std::optional<std::vector<std::uint8_t>> drawn_as_bytes(const Suite& suite,
                                                        std::span<const std::uint8_t> input);

}  // namespace ccdfuzz
