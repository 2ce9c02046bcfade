#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ccdfuzz {

/// The name of the target that this program is. Each target defines it.
extern const std::string_view kFuzzTarget;

/// What every libFuzzer target of claims does: puts the bytes to one of its claims (claim_input). A
/// failure is printed with its operands and ends the process, so that libFuzzer keeps the input.
/// What links this has libFuzzer draw every other input (drawn_input), but for texts.
int check_input(std::span<const std::uint8_t> bytes);

}  // namespace ccdfuzz
