#include "generators/draw/shrink_choices.hpp"

#include <algorithm>
#include <bit>

namespace ccdfuzz {

namespace {

/// Simpler values of one number. Its lowest bit may be a sign (Draw::integer), so it is
/// kept where others go.
std::vector<std::uint64_t> simpler_numbers(std::uint64_t x) {
  std::vector<std::uint64_t> out;
  const auto add = [&](std::uint64_t y) {
    if (y < x && std::find(out.begin(), out.end(), y) == out.end()) out.push_back(y);
  };
  if (x == 0) return out;
  add(0);
  add(1);
  const int width = static_cast<int>(std::bit_width(x));
  for (int bits = width - 1; bits >= 1; bits -= bits > 16 ? 8 : bits > 4 ? 3 : 1) {
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    add((x & ~mask) | (x & 1));  // fewer significant bits
    add((x >> bits << 1) | (x & 1));
  }
  add(x / 2);
  if (x >= 2) add(x - 2);
  add(x - 1);
  return out;
}

}  // namespace

bool simpler(const ChoiceNumbers& x, const ChoiceNumbers& y) {
  if (x.size() != y.size()) return x.size() < y.size();
  return x < y;
}

std::vector<ChoiceNumbers> simpler_choices(const ChoiceNumbers& numbers) {
  std::vector<ChoiceNumbers> out;
  const std::size_t size = numbers.size();
  // A source at its end gives zeros, so trailing ones say nothing.
  std::size_t used = size;
  while (used > 0 && numbers[used - 1] == 0) --used;
  const auto end = [&](std::size_t at) {
    return numbers.begin() + static_cast<std::ptrdiff_t>(at);
  };
  if (used < size) out.emplace_back(numbers.begin(), end(used));
  for (std::size_t kept = used / 2; kept < used;
       kept += std::max<std::size_t>(1, (used - kept) / 2)) {
    out.emplace_back(numbers.begin(), end(kept));
  }
  for (std::size_t length = std::bit_floor(std::max<std::size_t>(used / 2, 1)); length > 0;
       length /= 2) {
    for (std::size_t from = 0; from + length <= used; from += length) {
      ChoiceNumbers without(numbers.begin(), end(from));
      without.insert(without.end(), end(from + length), end(used));
      out.push_back(std::move(without));
      ChoiceNumbers zeroed = numbers;
      std::fill_n(zeroed.begin() + static_cast<std::ptrdiff_t>(from), length, 0);
      if (length > 1 && zeroed != numbers) out.push_back(std::move(zeroed));
    }
  }
  for (std::size_t i = 0; i < used; ++i) {
    for (const std::uint64_t x : simpler_numbers(numbers[i])) {
      out.push_back(numbers);
      out.back()[i] = x;
    }
  }
  return out;
}

ChoiceNumbers shrunk(ChoiceNumbers numbers, std::uint64_t tries,
                     const std::function<bool(const ChoiceNumbers&)>& keeps) {
  const auto take = [&](ChoiceNumbers candidate) {
    if (tries == 0 || !simpler(candidate, numbers)) return false;
    --tries;
    if (!keeps(candidate)) return false;
    numbers = std::move(candidate);
    return true;
  };
  const auto at = [](ChoiceNumbers& list, std::size_t i) {
    return list.begin() + static_cast<std::ptrdiff_t>(i);
  };
  for (bool better = true; better && tries > 0;) {
    better = false;
    for (std::size_t length = std::bit_floor(numbers.size()); length > 0; length /= 2) {
      for (std::size_t from = 0; from + length <= numbers.size();) {
        ChoiceNumbers without = numbers;
        without.erase(at(without, from), at(without, from + length));
        if (take(std::move(without))) {
          better = true;
          continue;
        }
        ChoiceNumbers zeroed = numbers;
        std::fill_n(at(zeroed, from), length, 0);
        better = take(std::move(zeroed)) || better;
        from += length;
      }
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      for (bool less = true; less;) {
        less = false;
        for (const std::uint64_t x : simpler_numbers(numbers[i])) {
          ChoiceNumbers changed = numbers;
          changed[i] = x;
          less = take(std::move(changed));
          better = better || less;
          if (less) break;
        }
      }
    }
  }
  return numbers;
}

}  // namespace ccdfuzz
