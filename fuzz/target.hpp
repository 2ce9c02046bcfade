#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ccdfuzz {

/// What every libFuzzer target does: checks the named property on the choices that the bytes are.
/// A failure is printed with its operands and ends the process, so that libFuzzer keeps the input.
int check_bytes(std::string_view property, const std::uint8_t* data, std::size_t size);

/// The same with one of several properties: which, the first byte says.
int check_bytes_of_any(std::span<const std::string_view> properties, const std::uint8_t* data,
                       std::size_t size);

}  // namespace ccdfuzz
