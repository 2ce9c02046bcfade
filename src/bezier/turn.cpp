#include "bezier/turn.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/double_parts.hpp"
#include "numeric/dyadic.hpp"

namespace ccdfuzz {

namespace {

std::optional<InputError> fault_of_numbers(const char* field, const auto& numbers) {
  for (int i = 0; i < static_cast<int>(numbers.size()); ++i) {
    const double x = numbers.begin()[i];
    if (is_finite(x)) continue;
    return InputError{fmt::format("{}[{}]", field, i), fmt::format("{} is not finite", x)};
  }
  return std::nullopt;
}

Dyadic product_of(const std::vector<double>& a, const std::vector<double>& b) {
  Dyadic product;
  for (size_t i = 0; i < a.size(); ++i) {
    product = product + Dyadic::exact(a[i]) * Dyadic::exact(b[i]);
  }
  return product;
}

std::optional<InputError> fault_of_spin(const std::vector<double>& spin) {
  if (spin.size() != 3) {
    return InputError{"velocity", fmt::format("has {} numbers, and needs 3", spin.size())};
  }
  if (auto fault = fault_of_numbers("velocity", spin)) return fault;
  const Dyadic fastest = Dyadic::exact(kFastestSpin);
  if (product_of(spin, spin) <= fastest * fastest) return std::nullopt;
  return InputError{"velocity", fmt::format("[{}] is of more than {} radians in [0, 1]",
                                            fmt::join(spin, ", "), kFastestSpin)};
}

}  // namespace

std::optional<InputError> fault_of(const BodyTurn& turn) {
  if (auto fault = fault_of_numbers("centre", turn.centre)) return fault;
  if (turn.is_spin() && turn.from.empty() && turn.to.empty()) return fault_of_spin(turn.spin);
  for (const auto& [field, numbers] : {std::pair("from", &turn.from), std::pair("to", &turn.to)}) {
    if (turn.is_spin() || (numbers->size() != 4 && numbers->size() != 2)) {
      return InputError{field, fmt::format("has {} numbers, and needs 4 of a quaternion or 2 of an "
                                           "angle",
                                           numbers->size())};
    }
    if (auto fault = fault_of_numbers(field, *numbers)) return fault;
  }
  if (turn.from.size() != turn.to.size()) {
    return InputError{"to",
                      fmt::format("has {} numbers, and from {}", turn.to.size(), turn.from.size())};
  }
  const int sign = product_of(turn.from, turn.to).sign();
  if (sign > 0) return std::nullopt;
  const char* const help = sign < 0 && turn.is_quaternion() ? ": give -to, the same rotation" : "";
  return InputError{"to", fmt::format("[{}] makes from·to {}, and it must be > 0{}",
                                      fmt::join(turn.to, ", "), sign < 0 ? "< 0" : "0", help)};
}

}  // namespace ccdfuzz
