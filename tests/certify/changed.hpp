#pragma once

#include <gtest/gtest.h>

#include "case/query.hpp"

namespace ccdfuzz {

/// Whether a check accepts a proof of a valid query, after a change of both.
template <class Proof, class Check, class Change>
bool holds_changed(Query query, Proof proof, const Check& check, const Change& change) {
  change(query, proof);
  EXPECT_TRUE(is_valid(query));
  return check(query, proof).has_value();
}

}  // namespace ccdfuzz
