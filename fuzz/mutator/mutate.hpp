#pragma once

#include <span>
#include <string_view>

#include "fuzz/mutator/witnessed_query.hpp"

namespace ccdfuzz {

/// One way to mutate.
struct Move {
  std::string_view name;
  bool (*apply)(WitnessedQuery& q, const WitnessedQuery& other, Draw& draw);
};

/// All moves.
std::span<const Move> moves();

/// A mutant of q: one to four moves, or none where none of those tried is possible. Every number of
/// it is a finite double, it is a valid query, and it has its contact exactly. other: where parts
/// of patches may come from. Depends on the arguments alone.
WitnessedQuery mutate(const WitnessedQuery& q, const WitnessedQuery& other, Draw& draw);

}  // namespace ccdfuzz
