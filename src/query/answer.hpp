#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "bezier/patch.hpp"

namespace ccdfuzz {

enum class Verdict : std::uint8_t { kHit, kMiss, kUndecided };

/// What a method says of a query.
struct Answer {
  Verdict verdict = Verdict::kUndecided;
  /// hit: the method's time of impact. undecided: the time before which the method found no
  /// contact, if it knows one. miss: absent.
  std::optional<double> toi;
  /// hit: parameters of the contact on each patch.
  std::array<Uv<double>, 2> uv{};
  /// Pairs of boxes taken from the queue.
  std::uint64_t pops = 0;
  /// The most memory that the queue, and what a method keeps of the patches for it, took, in bytes.
  std::uint64_t bytes = 0;
  double seconds = 0;
  /// Why it is undecided, or what went wrong; empty if nothing is to be said.
  std::string note;
};

}  // namespace ccdfuzz
