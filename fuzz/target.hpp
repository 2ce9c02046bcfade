#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ccdfuzz {

/// The name of the suite that this program checks (suite.cpp).
extern const std::string_view kSuite;

/// Checks one of the suite's claims on the bytes (claim_input). A failure is printed with its
/// operands and ends the process, so that libFuzzer keeps the input. What links this mutates and
/// crosses choices (generators/draw/mutate_choices.hpp), and draws every other input anew; but not
/// texts.
int check_input(std::span<const std::uint8_t> bytes);

}  // namespace ccdfuzz
