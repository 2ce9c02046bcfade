#pragma once

#include <concepts>
#include <cstdint>

/// What the planted sources (plant.cpp) ask at each place where a fault stands. One fault or none
/// is active in a process; this header is part of no other build.
namespace ccdfuzz::planted {

inline int active_fault = 0;  ///< its number; 0: none
inline std::uint64_t reached = 0, triggered = 0;

/// For statements.
inline bool active(int fault) {
  if (active_fault != fault) return false;
  ++reached, ++triggered;
  return true;
}

/// For expressions: the faulty value where that fault is active. It is triggered where it differs.
template <class Faulty, class Original>
auto choose(int fault, const Faulty& faulty, const Original& original) -> decltype(original()) {
  if (active_fault != fault) return original();
  ++reached;
  const auto value = static_cast<decltype(original())>(faulty());
  if constexpr (std::equality_comparable<decltype(original())>) {
    if (!(value == original())) ++triggered;
  } else {
    ++triggered;
  }
  return value;
}

}  // namespace ccdfuzz::planted

#define CCDFUZZ_PLANT(fault, faulty, original) \
  ::ccdfuzz::planted::choose(                  \
      fault, [&] { return faulty; }, [&] { return original; })
