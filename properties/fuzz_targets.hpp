#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "generators/draw/draw.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// A libFuzzer target that puts its bytes to claims (fuzz/NAME.cpp).
struct FuzzTarget {
  std::string_view name;
  std::string_view find;  ///< what a counterexample to one of them is: "refuted bound"
  bool reads_texts;       ///< of one claim, whose draws would be of no use
  std::vector<Property> claims;
};

/// The names of all.
std::vector<std::string_view> fuzz_targets();

/// Errors: an unknown name, with those that there are; a claim that is no property.
Result<FuzzTarget> fuzz_target_named(std::string_view name);

/// What an input of a target is: one of its claims, and where the choices come from that it is put
/// to: bytes, or draws.
struct ClaimInput {
  Property property;
  std::span<const std::uint8_t> bytes;
  std::optional<std::uint64_t> seed;  ///< of draws, in place of bytes

  Draw choices() const;
};

/// The same draws as those of `ccdfuzz check --seed S --first 0 --count 1`.
Draw draws_of(std::uint64_t seed);

/// Where a target reads texts, they are the bytes. Any other's first byte says which claim, in its
/// lower bits, and by the highest whether the next eight are a seed, the lowest first. None without
/// the first byte.
std::optional<ClaimInput> claim_input(const FuzzTarget& target,
                                      std::span<const std::uint8_t> bytes);

/// A draw of any claim as an input of a target that reads no texts.
std::vector<std::uint8_t> drawn_input(Draw& random);
/// The same choices as bytes, which can be changed one by one, where the input is one of draws.
/// Runs the claim.
std::optional<std::vector<std::uint8_t>> drawn_as_bytes(const FuzzTarget& target,
                                                        std::span<const std::uint8_t> input);

}  // namespace ccdfuzz
