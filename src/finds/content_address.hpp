#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <utility>

#include "case/query.hpp"

namespace ccdfuzz {

/// The address of a query in a corpus: 32 hex digits. They are the 128-bit XXH3 hash of its
/// patches, with the bits of all their numbers, its t_max and its separation. Equal on every
/// machine. −0 and 0 differ but in t_max and separation: a method may take them apart.
std::string content_address(const Query& query);

/// How large a query is to a reader, first field first.
struct CaseSize {
  /// Over all numbers of the patches, t_max and separation: bits from the highest to the lowest
  /// that is set; none for 0.
  std::uint64_t significant_bits = 0;
  /// Between the largest and the smallest coordinate that is not 0: the difference of the
  /// exponents.
  int exponent_spread = 0;

  friend auto operator<=>(const CaseSize&, const CaseSize&) = default;
};

CaseSize size_of(const Query& query);

/// The order of "smaller"; total, since different queries have different addresses.
using Rank = std::pair<CaseSize, std::string>;
inline Rank rank_of(const Query& query) {
  return {size_of(query), content_address(query)};
}

}  // namespace ccdfuzz
