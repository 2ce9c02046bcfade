#pragma once

#include <cstddef>
#include <cstdint>

/// libFuzzer's own mutator. Other engines and replaying have none.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                                              std::size_t max_size);
