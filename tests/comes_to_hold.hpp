#pragma once

#include <unistd.h>

#include <chrono>

namespace ccdfuzz {

/// Waits until a condition of another process holds, for ten minutes at most; whether it does.
template <class Condition>
bool comes_to_hold(const Condition& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(10);
  while (!holds() && std::chrono::steady_clock::now() < end) ::usleep(1000);
  return holds();
}

}  // namespace ccdfuzz
