#pragma once

#include <array>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>

#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// What one input showed of a property.
struct Check {
  enum class Status : std::uint8_t {
    kHolds,
    kFails,
    kDiscarded,  ///< the input is outside what the claim speaks of
  };
  Status status = Status::kHolds;
  /// Fails: what was claimed, what was found, and every operand as hex floats, so that the text
  /// alone gives the input back. Discarded: why.
  std::string text;

  static Check holds() { return {}; }
  static Check discarded(std::string why) { return {Status::kDiscarded, std::move(why)}; }
  static Check fails(std::string text) { return {Status::kFails, std::move(text)}; }
  static Check fails(const std::exception& error) {
    return fails(std::string("an exception: ") + error.what());
  }
};

inline constexpr std::array kCheckStatuses = {Check::Status::kHolds, Check::Status::kFails,
                                              Check::Status::kDiscarded};
constexpr const auto& all_of(Check::Status) {
  return kCheckStatuses;
}
/// What a property does on an input: it "holds", "fails" or "is discarded".
constexpr std::string_view name_of(Check::Status status) {
  constexpr std::array<std::string_view, kCheckStatuses.size()> kNames = {"holds", "fails",
                                                                          "is discarded"};
  return kNames[static_cast<std::size_t>(status)];
}

/// What is known of a claim. A claim that is false stays as it was made, and is marked.
enum class Expectation : std::uint8_t {
  kHolds,  ///< no counterexample is known; one is a finding
  kFails,  ///< counterexamples are known, and not to find one means that the harness is broken
};

/// One claim, checked by any driver: GoogleTest's examples and RapidCheck (tests/properties),
/// libFuzzer and replay (fuzz), none of which it knows.
struct Property {
  std::string_view name;   ///< "subject.claim", unique
  std::string_view claim;  ///< in words, one sentence
  std::string_view source;
  Expectation expected = Expectation::kHolds;
  /// Draws an input and checks the claim on it. The same choices give the same result.
  Check (*check)(Draw&) = nullptr;
};

/// property.check, where an exception is a failure: what drivers call.
Check run(const Property& property, Draw& choices);

}  // namespace ccdfuzz
