#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ccdfuzz {

/// What every libFuzzer target of claims does: puts the bytes to one of the target's (claim_input).
/// A failure is printed with its operands and ends the process, so that libFuzzer keeps the input.
/// Always the same target in a process. What links this has libFuzzer make every other input of
/// draws (drawn_input).
int check_target(std::string_view target, std::span<const std::uint8_t> bytes);

}  // namespace ccdfuzz
