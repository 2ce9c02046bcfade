#pragma once

#include <algorithm>
#include <vector>

namespace ccdfuzz {

/// The upper median. Requires values.
template <class Value>
Value median(std::vector<Value> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace ccdfuzz
