#pragma once

#include <span>
#include <string_view>

#include "generators/contact.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// One way to mutate.
struct Move {
  std::string_view name;
  bool (*apply)(Contact& q, const Contact& other, Draw& draw);
};

/// All moves.
std::span<const Move> moves();

/// A mutant of q: one to four moves, or none where none of those tried is possible. Every number of
/// it is a finite double, it is a valid query, and it has its contact exactly. other: where parts
/// of patches may come from. Depends on the arguments alone.
Contact mutate(const Contact& q, const Contact& other, Draw& draw);

}  // namespace ccdfuzz
