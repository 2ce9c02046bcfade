#pragma once

#include <rapidcheck.h>

#include <type_traits>

#include "properties/shrink.hpp"

namespace ccdfuzz::rc_gen {

/// Sequences of choices, mostly small ones: what breaks geometry are coincidences. They shrink as
/// everything does that is drawn from choices (properties/shrink.hpp), not as RapidCheck's vectors.
inline rc::Gen<ChoiceNumbers> choices() {
  constexpr int kSize = 300;
  const auto number =
      rc::gen::oneOf(rc::gen::inRange<std::uint64_t>(0, 8), rc::gen::inRange<std::uint64_t>(0, 256),
                     rc::gen::arbitrary<std::uint64_t>());
  const auto numbers = rc::gen::resize(kSize, rc::gen::container<ChoiceNumbers>(number));
  return rc::gen::shrink(rc::gen::noShrink(numbers), [](const ChoiceNumbers& x) {
    return rc::seq::fromContainer(simpler_choices(x));
  });
}

/// What `make` makes of choices. Simpler choices draw simpler values, so its shrinks stay within
/// what `make` can make: every one is as exact as the value itself.
template <class Make>
auto drawn(Make make) {
  return rc::gen::map(choices(), [make](const ChoiceNumbers& numbers) {
    Draw source = Draw::from_numbers(numbers);
    return make(source);
  });
}

}  // namespace ccdfuzz::rc_gen
