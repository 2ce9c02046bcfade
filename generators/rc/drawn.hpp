#pragma once

#include <rapidcheck.h>

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>

#include "generators/draw/shrink_choices.hpp"

namespace ccdfuzz::gen {

/// A value and the choices that it was made of.
template <class T>
struct Made {
  std::shared_ptr<const T> value;
  ChoiceNumbers numbers;
};

/// Makes a value of stored choices; nullopt where these make none. What it says that the value was
/// made of is no less simple than what was given.
template <class T>
using Maker = std::function<std::optional<Made<T>>(const ChoiceNumbers&)>;

/// How many simpler values are tried, whatever they cost, after which what is left stands.
inline constexpr int kMostShrinks = 20'000;

template <class T>
rc::Shrinkable<T> shrinking(const Made<T>& made, ChoiceShrinker shrinker, const Maker<T>& make,
                            int tries = kMostShrinks);

/// What a value shrinks to. RapidCheck would begin each search anew; what it takes goes on with the
/// choice after the one that was made simpler, as shrunk() does.
template <class T>
struct Shrinks {
  ChoiceShrinker shrinker;
  Maker<T> make;
  int tries;

  rc::Maybe<rc::Shrinkable<T>> operator()() {
    while (tries-- > 0) {
      const std::optional<ChoiceNumbers> candidate = shrinker.next();
      if (!candidate) break;
      const std::optional<Made<T>> simple = make(*candidate);
      if (!simple) continue;
      ChoiceShrinker from_there = shrinker;
      from_there.take(simple->numbers);
      return shrinking(*simple, std::move(from_there), make, tries);
    }
    return rc::Nothing;
  }
};

/// A value that shrinks as its choices do.
template <class T>
rc::Shrinkable<T> shrinking(const Made<T>& made, ChoiceShrinker shrinker, const Maker<T>& make,
                            int tries) {
  return rc::shrinkable::lambda([value = made.value] { return *value; },
                                [first = Shrinks<T>{std::move(shrinker), make, tries}] {
                                  return rc::Seq<rc::Shrinkable<T>>(first);
                                });
}

/// What `make` makes of a Draw. Half of all choices are small ones: what breaks geometry are
/// coincidences. Every value that it shrinks to is made by `make` too, so it is as exact.
template <class Make>
auto drawn(const Make& make) {
  using T = std::invoke_result_t<Make, Draw&>;
  const auto made_of = [make](Draw& draw) {
    auto value = std::make_shared<const T>(make(draw));
    ChoiceNumbers numbers = draw.numbers();
    while (!numbers.empty() && numbers.back() == 0) numbers.pop_back();  // what an end gives
    return Made<T>{std::move(value), std::move(numbers)};
  };
  const Maker<T> again = [made_of](const ChoiceNumbers& numbers) -> std::optional<Made<T>> {
    Draw draw = Draw::from_numbers(numbers);
    try {
      return made_of(draw);
    } catch (const Discarded&) {
      return std::nullopt;
    }
  };
  return rc::Gen<T>([made_of, again](const rc::Random& random, int) {
    Draw draw = Draw::mostly_small(Random(rc::Random(random).next()));
    const Made<T> made = made_of(draw);
    return shrinking(made, ChoiceShrinker(made.numbers), again);
  });
}

/// Sequences of choices, for what draws for itself.
rc::Gen<ChoiceNumbers> choices();

}  // namespace ccdfuzz::gen
