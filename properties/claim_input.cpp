#include "properties/claim_input.hpp"

#include <algorithm>

namespace ccdfuzz {

namespace {

/// In the first byte.
constexpr std::uint8_t kDrawn = 128;

}  // namespace

Draw ClaimInput::choices() const {
  return seed ? draws_of(*seed) : Draw::from_bytes(bytes);
}

Draw draws_of(std::uint64_t seed) {
  return Draw::mostly_small(Random::keyed({seed, 0}));
}

std::optional<ClaimInput> claim_input(const Suite& suite, std::span<const std::uint8_t> bytes) {
  if (suite.reads_text) return ClaimInput{suite.claims[0], bytes, {}};
  if (bytes.empty()) return std::nullopt;
  const std::size_t claim = bytes[0] & ~kDrawn;
  const std::vector<Property> claims = suite.thought_to_hold();
  ClaimInput input{claims[claim % claims.size()], bytes.subspan(1), {}};
  if ((bytes[0] & kDrawn) == 0) return input;
  std::uint64_t seed = 0;
  const std::size_t given = std::min(input.bytes.size(), sizeof seed);
  for (std::size_t i = 0; i < given; ++i) seed |= std::uint64_t{input.bytes[i]} << 8 * i;
  input.seed = seed;
  return input;
}

std::vector<std::uint8_t> drawn_input(Draw& random) {
  std::vector<std::uint8_t> input = {static_cast<std::uint8_t>(kDrawn | random.below(kDrawn))};
  for (std::size_t i = 0; i < sizeof(std::uint64_t); ++i) {
    input.push_back(static_cast<std::uint8_t>(random.below(256)));
  }
  return input;
}

std::optional<std::vector<std::uint8_t>> drawn_as_bytes(const Suite& suite,
                                                        std::span<const std::uint8_t> input) {
  const auto drawn = claim_input(suite, input);
  if (!drawn || !drawn->seed) return std::nullopt;
  Draw choices = drawn->choices();
  run(drawn->property, choices);
  std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(input[0] & ~kDrawn)};
  bytes.insert(bytes.end(), choices.bytes().begin(), choices.bytes().end());
  return bytes;
}

}  // namespace ccdfuzz
