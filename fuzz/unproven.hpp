#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/mutator/case_bytes.hpp"

namespace ccdfuzz {

/// Methods that may lose a contact. fuzz_query and fuzz_witnessed ask one of them on each input,
/// since they are ten times as slow as those that are proven. New ones come last: an input names
/// its method by the place in this list.
inline constexpr std::array kUnproven = {
    "tdibm",   "tdibm-h:1e-16",   "tdibm-h:1e-12", "tdibm-h:1e-12@absolute",
    "tdibm-e", "tdibm-e-literal", "trad"};

/// The place of the method that an input names; of any byte, since other fuzzers write any.
inline std::size_t unproven_of(std::span<const std::uint8_t> bytes) {
  return method_number(bytes) % kUnproven.size();
}

}  // namespace ccdfuzz
