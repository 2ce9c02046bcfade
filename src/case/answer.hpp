#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/enum_names.hpp"
#include "bezier/patch.hpp"

namespace ccdfuzz {

enum class Verdict : std::uint8_t {
  kHit,
  kMiss,
  kUndecided,
  kRefused,  ///< the query or an option is outside of what the method takes: it did not look at it
};

constexpr std::array<std::string_view, 4> names_of(Verdict) {
  return {"hit", "miss", "undecided", "refused"};
}

/// What an answer cost.
struct Cost {
  /// Pairs of boxes taken from the queue.
  std::uint64_t pops = 0;
  /// The most memory that the queue, and what a method keeps of the patches for it, took, in bytes.
  std::uint64_t bytes = 0;
  /// Wall time, as the method itself has it or timed_answer; otherwise 0.
  double seconds = 0;

  static void fields(auto& archive, auto& cost) {
    archive("pops", cost.pops);
    archive("bytes", cost.bytes);
    archive("seconds", cost.seconds);
  }

  friend bool operator==(const Cost&, const Cost&) = default;
};

/// What a method says of a query.
struct Answer : Cost {
  Verdict verdict = Verdict::kUndecided;
  /// hit: the method's time of impact. undecided: the time before which the method found no
  /// contact, if it knows one. miss, refused: absent.
  std::optional<double> toi;
  /// hit: parameters of the contact on each patch.
  std::array<Uv<double>, 2> uv{};
  /// Operations on 64-bit words of exact arithmetic, where doubles did not decide.
  std::uint64_t work = 0;
  /// refused: the field that is not taken, its value, and what is. undecided: why. Otherwise what
  /// went wrong; empty if nothing is to be said.
  std::string note;
  bool has_uv = true;  ///< for a hit: it says where

  static Answer hit(double at) {
    Answer answer;
    answer.verdict = Verdict::kHit;
    answer.toi = at;
    return answer;
  }
  static Answer miss() {
    Answer answer;
    answer.verdict = Verdict::kMiss;
    return answer;
  }

  /// A hit has a time, and what is undecided may.
  bool has_toi() const {
    return toi && (verdict == Verdict::kHit || verdict == Verdict::kUndecided);
  }
};

}  // namespace ccdfuzz
