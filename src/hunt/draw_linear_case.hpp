#pragma once

#include <cstdint>

#include "case/case.hpp"
#include "hunt/linear_class.hpp"

namespace ccdfuzz {

/// Linear case number `index` of such a class: degenerate in any of the ways that linear codes fail
/// on (draw_linear), with a truth that exact arithmetic decides and the checker accepts. Depends on
/// the arguments alone.
Case draw_linear_case(ContactClass contact, std::uint64_t seed, std::uint64_t index);

}  // namespace ccdfuzz
