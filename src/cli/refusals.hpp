#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "eval/rows.hpp"

namespace ccdfuzz {

inline const std::string& method_of(const Row& row) {
  return row.key.method;
}
template <class Group>
const std::string& method_of(const Group& group) {
  return group.method;
}

/// Says below a table which methods refused queries, and how many. Groups: a range of what has a
/// method and a `tally`.
template <class Groups>
void print_refusals(const Groups& groups) {
  struct Sum {
    std::string method;
    std::uint64_t asked = 0, refused = 0;
  };
  std::vector<Sum> sums;
  for (const auto& group : groups) {
    auto sum = std::ranges::find(sums, method_of(group), &Sum::method);
    if (sum == sums.end()) sum = sums.insert(sum, {method_of(group)});
    sum->asked += group.tally.n;
    sum->refused += group.tally.not_asked();
  }
  for (const Sum& sum : sums) {
    if (sum.refused == 0) continue;
    print_out(sum.asked == 0
                  ? fmt::format("\n{} was asked nothing: it refused all {} queries", sum.method,
                                sum.refused)
                  : fmt::format("\n{} refused {} of {} queries, which no other number counts",
                                sum.method, sum.refused, sum.asked + sum.refused));
    print_out(" (`ccdfuzz query` says why)\n");
  }
}

}  // namespace ccdfuzz
