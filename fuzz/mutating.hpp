#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace ccdfuzz {

struct CaseMutation {
  /// One mutant in so many is the fuzzer's own, which breaks the contact mostly; at least 1.
  std::uint64_t own_in = 8;
  /// How many methods an input can name; at least 1.
  std::uint8_t methods = 1;
};

/// What the custom mutator of a target on case bytes (fuzz/mutator/case_bytes.hpp) does: mutants
/// that keep their contact exactly, and their method seven times in eight. As
/// LLVMFuzzerCustomMutator: in place, returns the new size. A target that links this has
/// LLVMFuzzerCustomCrossOver, too: a case with parts of another, and its own method.
std::size_t mutate_case(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed,
                        const CaseMutation& options);

}  // namespace ccdfuzz
