#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// Simpler choices first: the shorter sequence, or of equal lengths the one that is less at the
/// first difference. What is drawn of simpler choices has fewer parts, fewer control points that
/// are not zero, fewer bits and smaller exponents.
bool simpler(const ChoiceNumbers& x, const ChoiceNumbers& y);

/// The way from a sequence to simpler ones, in the order in which they are worth trying. First,
/// parts are left out or made 0, the longest first. Then each number is made 0, halved, stripped of
/// low bits and lessened by little. Begins anew after each pass in which one was taken.
/// Deterministic.
class ChoiceShrinker {
 public:
  explicit ChoiceShrinker(ChoiceNumbers numbers);

  const ChoiceNumbers& numbers() const { return numbers_; }
  /// The next to try, simpler than numbers(). nullopt: a whole pass was tried in vain.
  std::optional<ChoiceNumbers> next();
  /// From now on this, which is no less simple than what next() gave last, is numbers().
  void take(ChoiceNumbers simpler);

 private:
  enum class Step : std::uint8_t { kWithout, kZeroed, kNumber };

  std::optional<ChoiceNumbers> step();
  void begin_pass();

  ChoiceNumbers numbers_;
  bool is_better_ = false;  ///< in this pass
  Step last_ = Step::kWithout;
  bool is_left_out_ = false;  ///< the part at at_ was tried to be left out, and not yet made 0
  std::size_t length_ = 0;    ///< that parts have; 0: single numbers
  std::size_t at_ = 0;        ///< the part begins here, or the number stands here
  std::size_t tried_ = 0;     ///< how many simpler values of the number at at_
};

/// The least that could be found with at most `tries` calls of `keeps`, which says whether a
/// sequence still shows what `numbers` shows. Deterministic.
ChoiceNumbers shrunk(ChoiceNumbers numbers, std::uint64_t tries,
                     const std::function<bool(const ChoiceNumbers&)>& keeps);

}  // namespace ccdfuzz
