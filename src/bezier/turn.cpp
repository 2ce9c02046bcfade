#include "bezier/turn.hpp"

#include <fmt/format.h>

#include "base/double_parts.hpp"
#include "numeric/dyadic.hpp"

namespace ccdfuzz {

std::optional<TurnFault> fault_of(const BodyTurn& turn) {
  for (const auto& [field, numbers] : {std::pair("from", &turn.from), std::pair("to", &turn.to)}) {
    if (numbers->size() != 4 && numbers->size() != 2) {
      return TurnFault{field, fmt::format("has {} numbers, and needs 4 of a quaternion or 2 of an "
                                          "angle",
                                          numbers->size())};
    }
    for (size_t i = 0; i < numbers->size(); ++i) {
      const double x = (*numbers)[i];
      if (!is_finite(x)) {
        return TurnFault{fmt::format("{}[{}]", field, i), fmt::format("{} is not finite", x)};
      }
    }
  }
  if (turn.from.size() != turn.to.size()) {
    return TurnFault{"to",
                     fmt::format("has {} numbers, and from {}", turn.to.size(), turn.from.size())};
  }
  for (int k = 0; k < 3; ++k) {
    if (is_finite(turn.centre[k])) continue;
    return TurnFault{fmt::format("centre[{}]", k), fmt::format("{} is not finite", turn.centre[k])};
  }
  Dyadic product;
  for (size_t i = 0; i < turn.from.size(); ++i) {
    product = product + Dyadic::exact(turn.from[i]) * Dyadic::exact(turn.to[i]);
  }
  if (product.sign() > 0) return std::nullopt;
  return TurnFault{"to",
                   "from·to is not > 0: give -to, which is the same rotation of a quaternion"};
}

}  // namespace ccdfuzz
