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

}  // namespace ccdfuzz
