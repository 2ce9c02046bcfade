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

ChoiceShrinker::ChoiceShrinker(ChoiceNumbers numbers) : numbers_(std::move(numbers)) {
  begin_pass();
}

void ChoiceShrinker::begin_pass() {
  is_better_ = is_left_out_ = false;
  length_ = std::bit_floor(numbers_.size());
  at_ = tried_ = 0;
}

/// The next one, simpler or not. nullopt at the end of a pass.
std::optional<ChoiceNumbers> ChoiceShrinker::step() {
  for (; length_ > 0; length_ /= 2, at_ = 0) {
    if (at_ + length_ > numbers_.size()) continue;
    ChoiceNumbers changed = numbers_;
    const auto from = changed.begin() + static_cast<std::ptrdiff_t>(at_);
    const auto to = from + static_cast<std::ptrdiff_t>(length_);
    last_ = is_left_out_ ? Step::kZeroed : Step::kWithout;
    if (is_left_out_) {
      std::fill(from, to, 0);
      at_ += length_;
    } else {
      changed.erase(from, to);
    }
    is_left_out_ = !is_left_out_;
    return changed;
  }
  last_ = Step::kNumber;
  for (; at_ < numbers_.size(); ++at_, tried_ = 0) {
    const std::vector<std::uint64_t> values = simpler_numbers(numbers_[at_]);
    if (tried_ == values.size()) continue;
    ChoiceNumbers changed = numbers_;
    changed[at_] = values[tried_++];
    return changed;
  }
  return std::nullopt;
}

std::optional<ChoiceNumbers> ChoiceShrinker::next() {
  while (true) {
    std::optional<ChoiceNumbers> changed = step();
    if (changed && simpler(*changed, numbers_)) return changed;
    if (changed) continue;
    if (!is_better_) return std::nullopt;
    begin_pass();
  }
}

void ChoiceShrinker::take(ChoiceNumbers simpler) {
  numbers_ = std::move(simpler);
  is_better_ = true;
  // Where a part was left out, another stands now; and a number may be lessened further.
  if (last_ == Step::kWithout) is_left_out_ = false;
  tried_ = 0;
}

ChoiceNumbers shrunk(ChoiceNumbers numbers, std::uint64_t tries,
                     const std::function<bool(const ChoiceNumbers&)>& keeps) {
  ChoiceShrinker shrinker(std::move(numbers));
  for (; tries > 0; --tries) {
    std::optional<ChoiceNumbers> candidate = shrinker.next();
    if (!candidate) break;
    if (keeps(*candidate)) shrinker.take(*std::move(candidate));
  }
  return shrinker.numbers();
}

}  // namespace ccdfuzz
