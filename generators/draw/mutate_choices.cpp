#include "generators/draw/mutate_choices.hpp"

#include <algorithm>
#include <limits>

namespace ccdfuzz {

namespace {

/// What any claim draws, or nearly; a source at its end gives zeros.
constexpr std::uint64_t kMostDrawn = 400;

std::uint64_t any_number(Draw& random) {
  constexpr std::uint64_t kSmall = 8, kByte = 256;
  switch (random.below(4)) {
    case 0:
    case 1:
      return random.below(kSmall);
    case 2:
      return random.below(kByte);
    default:
      return random.choose(std::numeric_limits<std::uint64_t>::max());
  }
}

std::uint64_t changed(std::uint64_t x, Draw& random) {
  switch (random.below(6)) {
    case 0:
      return 0;
    case 1:
      return x + 1;
    case 2:
      return x - (x > 0 ? 1 : 0);
    case 3:
      return x / 2;
    case 4:
      return x ^ std::uint64_t{1} << random.below(64);
    default:
      return any_number(random);
  }
}

void change_once(ChoiceNumbers& numbers, Draw& random) {
  if (numbers.empty()) {
    numbers.push_back(any_number(random));
    return;
  }
  const auto place = [&] { return static_cast<std::ptrdiff_t>(random.below(numbers.size())); };
  const std::ptrdiff_t at = place();
  const auto left = numbers.size() - static_cast<std::size_t>(at);
  const auto length = static_cast<std::ptrdiff_t>(1 + random.below(std::min<std::size_t>(left, 8)));
  const auto first = numbers.begin() + at;
  switch (random.below(8)) {
    case 0:
      numbers.erase(first, first + length);
      break;
    case 1:
      numbers.insert(first, any_number(random));
      break;
    case 2: {
      const ChoiceNumbers copied(first, first + length);
      numbers.insert(numbers.begin() + place(), copied.begin(), copied.end());
      break;
    }
    case 3:
      numbers[static_cast<std::size_t>(place())] = *first;
      break;
    default:
      *first = changed(*first, random);
  }
}

}  // namespace

ChoiceNumbers mutated(ChoiceNumbers numbers, Draw& random) {
  for (std::uint64_t left = 1 + random.below(4); left > 0; --left) change_once(numbers, random);
  return numbers;
}

ChoiceNumbers crossed(const ChoiceNumbers& a, const ChoiceNumbers& b, Draw& random) {
  const auto cut = static_cast<std::size_t>(random.below(std::max(a.size(), b.size()) + 1));
  ChoiceNumbers child(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(std::min(cut, a.size())));
  child.insert(child.end(), b.begin() + static_cast<std::ptrdiff_t>(std::min(cut, b.size())),
               b.end());
  return child;
}

ChoiceNumbers drawn_choices(Draw& random) {
  ChoiceNumbers numbers(random.below(kMostDrawn) + 1);
  for (std::uint64_t& x : numbers) x = any_number(random);
  return numbers;
}

}  // namespace ccdfuzz
