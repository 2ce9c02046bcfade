#include "properties/claim_input.hpp"

#include <algorithm>
#include <string_view>

#include "generators/draw/choice_bytes.hpp"
#include "io/hash_name.hpp"

namespace ccdfuzz {

namespace {

std::array<std::uint8_t, kClaimHead> head_of(std::string_view property) {
  std::array<std::uint8_t, kClaimHead> head{};
  const std::string digest = hash_name(property);
  std::copy_n(digest.begin(), kClaimHead, head.begin());
  return head;
}

}  // namespace

std::optional<ClaimInput> claim_input(const Suite& suite, std::span<const std::uint8_t> bytes) {
  if (suite.is_of_bytes) {
    return ClaimInput{suite.claims[0], ChoiceNumbers(bytes.begin(), bytes.end())};
  }
  if (bytes.size() < kClaimHead) return std::nullopt;
  for (const Property& property : suite.claims) {
    if (property.expected != Expectation::kHolds) continue;
    if (!std::ranges::equal(head_of(property.name), bytes.first(kClaimHead))) continue;
    return ClaimInput{property, choices_of(bytes.subspan(kClaimHead))};
  }
  return std::nullopt;
}

std::vector<std::uint8_t> to_bytes(const ClaimInput& input) {
  const auto head = head_of(input.property.name);
  std::vector<std::uint8_t> bytes(head.begin(), head.end());
  const std::vector<std::uint8_t> choices = bytes_of(input.choices);
  bytes.insert(bytes.end(), choices.begin(), choices.end());
  return bytes;
}

}  // namespace ccdfuzz
