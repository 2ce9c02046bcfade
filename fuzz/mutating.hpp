#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace ccdfuzz {

/// What the custom mutator of a target on case bytes (fuzz/mutator/case_bytes.hpp) does: mutants
/// that keep their contact exactly; one in `every` is the fuzzer's own, which breaks it mostly.
/// As LLVMFuzzerCustomMutator: in place, returns the new size. A target that links this has
/// LLVMFuzzerCustomCrossOver, too: a case with parts of another.
std::size_t mutate_case(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed,
                        std::uint64_t every);

}  // namespace ccdfuzz
