#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// Choices as a fuzzer has them: each number as LEB128, seven bits a byte, the lowest first, the
/// top bit of a byte saying that another follows.
std::vector<std::uint8_t> bytes_of(const ChoiceNumbers& numbers);
/// The choices that any bytes are; bits beyond the 64th of a number are dropped.
/// choices_of(bytes_of(x)) is x.
ChoiceNumbers choices_of(std::span<const std::uint8_t> bytes);

/// "1,0,255": choices on a command line and in messages; '' for none.
std::string to_word(const ChoiceNumbers& numbers);
/// Errors: what is no list of whole numbers below 2^64 with commas between them.
Result<ChoiceNumbers> parse_choices(const std::string& text);

}  // namespace ccdfuzz
