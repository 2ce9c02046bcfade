#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/mutator/case_bytes.hpp"
#include "generators/contact.hpp"
#include "generators/draw/draw.hpp"

// Mutation of contacts, and of libFuzzer's inputs that are contacts. Users include
// <ccdfuzz/mutate.hpp>.
namespace ccdfuzz {

/// A mutant of q: one to four moves, or none where none of those tried is possible. Every number of
/// it is a finite double, it is a valid query, and it has its contact exactly. other: where parts
/// of patches may come from. range: what moves may make of a query in it. Depends on the arguments
/// alone.
Contact mutate(const Contact& q, const Contact& other, Draw& draw,
               QueryRange range = QueryRange::kPlain);

struct CaseMutation {
  /// One mutant in this many is libFuzzer's own, which mostly breaks the contact; at least 1.
  std::uint64_t own_in = 8;
  /// One mutant in this many is a contact drawn anew (draw_witnessed), half of these vertex-face or
  /// edge-edge; at least 1. So is what an input becomes that is none. No mutation makes surfaces of
  /// points and curves.
  std::uint64_t drawn_in = 16;
  /// How many methods an input can name; at least 1.
  std::uint8_t methods = 1;
  QueryRange range = QueryRange::kPlain;
};

/// For LLVMFuzzerCustomMutator where inputs are case bytes (to_bytes): makes a mutant that
/// keeps its contact exactly, and its method seven times in eight. Changes the data in place.
/// Returns the new size, 0 where it is more than max_size.
std::size_t mutate_case(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed,
                        const CaseMutation& options = {});

/// For LLVMFuzzerCustomCrossOver there: makes a mutant of the first with parts of the second,
/// and its method. Returns the size of what is in `out`, 0 where there is none.
std::size_t cross_cases(std::span<const std::uint8_t> first, std::span<const std::uint8_t> second,
                        std::uint8_t* out, std::size_t max_size, unsigned seed,
                        QueryRange range = QueryRange::kPlain);

}  // namespace ccdfuzz
