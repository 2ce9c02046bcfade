#include "finds/content_address.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>

#include "base/double_parts.hpp"
#include "files/case_json.hpp"
#include "io/hash_name.hpp"

namespace ccdfuzz {

std::string content_address(const Query& query) {
  Case bare;
  bare.query = query;
  if (compare(query.t_max, 0) == 0) bare.query.t_max = 0;  // −0 is the same horizon
  return hash_name(to_json(bare));
}

CaseSize size_of(const Query& query) {
  CaseSize size;
  int lowest = std::numeric_limits<int>::max(), highest = std::numeric_limits<int>::min();
  const auto count_bits = [&](const DoubleParts& parts) {
    const auto magnitude = static_cast<std::uint64_t>(std::abs(parts.mantissa));
    size.significant_bits += static_cast<unsigned>(std::bit_width(magnitude));
  };
  const auto count = [&](double x) {
    const DoubleParts parts = parts_of(x);
    count_bits(parts);
    if (parts.mantissa == 0) return;
    lowest = std::min(lowest, parts.top());
    highest = std::max(highest, parts.top());
  };
  for (const MovingPatch<double>& patch : query.patches) for_each_number(patch, count);
  count_bits(parts_of(query.t_max));
  count_bits(parts_of(query.separation));
  if (lowest <= highest) size.exponent_spread = highest - lowest;
  return size;
}

}  // namespace ccdfuzz
