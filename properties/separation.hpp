#pragma once

#include "properties/envelope.hpp"

namespace ccdfuzz {

/// Step III under a policy: where it says that max f + max g < 0, that is so in exact arithmetic.
template <class Policy>
void claim_separation_is_true(const LinePairs& pairs) {
  const Policy policy;
  const Lines<double> f = envelope_of(policy, pairs.f, pairs.window);
  const Lines<double> g = envelope_of(policy, pairs.g, pairs.window);
  const auto found = separation(policy, f, g, pairs.window);
  if (!found) return;
  const ExactLines all_f = exact_lines(pairs.f), all_g = exact_lines(pairs.g);
  const auto sign_at = [&](const Dyadic& t) {
    return (maximum(all_f, t) + maximum(all_g, t)).sign();
  };
  // max f + max g is convex: ≤ 0 at both ends and < 0 between them once means < 0 between them.
  const Dyadic lo = Dyadic::exact(found->lo), hi = Dyadic::exact(found->hi);
  CLAIM(sign_at(lo) <= (found->has_lo ? -1 : 0));
  CLAIM(sign_at(hi) <= (found->has_hi ? -1 : 0));
  CLAIM(lo == hi || sign_at((lo + hi).scaled(-1)) < 0);
}

}  // namespace ccdfuzz
