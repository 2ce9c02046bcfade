#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>

/// What the planted sources (plant.cpp) ask at each place that has a fault. One fault or none
/// is active in a process, or all are watched; this header is part of no other build.
namespace ccdfuzz::planted {

inline constexpr int kNone = 0, kWatchAll = -1;
inline int active_fault = kNone;  ///< its number, from 1
inline std::uint64_t reached = 0, triggered = 0;

/// Where all faults are watched, the sources do what is right, and ask at each place whether the
/// wrong value would have been another one. As long as it is not, a run with that fault takes the
/// same course.
struct Watched {
  static constexpr std::size_t kMost = 1024;
  std::array<bool, kMost> reached{}, triggered{};
  int asked = kNone;  ///< the last whose wrong value was computed
};
inline Watched* watched = nullptr;

/// A statement may do anything: it is triggered where it is reached.
inline bool active(int fault) {
  if (active_fault == kWatchAll) watched->reached[fault] = watched->triggered[fault] = true;
  if (active_fault != fault) return false;
  ++reached, ++triggered;
  return true;
}

/// Whether to go on with one value may differ from going on with the other.
template <class Value>
bool differ(const Value& x, const Value& y) {
  if constexpr (std::floating_point<Value>) {
    return !(x == y) || std::signbit(x) != std::signbit(y);
  } else if constexpr (std::equality_comparable<Value>) {
    return !(x == y);
  } else {
    return true;
  }
}

template <class Faulty, class Original>
auto watch(int fault, const Faulty& faulty, const Original& original) -> decltype(original()) {
  const auto value = original();
  if (watched->triggered[fault]) return value;
  watched->reached[fault] = true;
  watched->asked = fault;
  active_fault = kNone;  // as in a run with this fault, no other is active in its value
  try {
    watched->triggered[fault] = differ(static_cast<decltype(original())>(faulty()), value);
  } catch (...) {
    watched->triggered[fault] = true;
  }
  active_fault = kWatchAll;
  return value;
}

/// For expressions: the faulty value where that fault is active. It is triggered where it differs.
template <class Faulty, class Original>
auto choose(int fault, const Faulty& faulty, const Original& original) -> decltype(original()) {
  if (active_fault == kWatchAll) return watch(fault, faulty, original);
  if (active_fault != fault) return original();
  ++reached;
  const auto value = static_cast<decltype(original())>(faulty());
  if (differ(value, original())) ++triggered;
  return value;
}

}  // namespace ccdfuzz::planted

#define CCDFUZZ_PLANT(fault, faulty, original) \
  ::ccdfuzz::planted::choose(                  \
      fault, [&] { return faulty; }, [&] { return original; })
