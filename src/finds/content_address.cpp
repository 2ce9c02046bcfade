#include "finds/content_address.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>

#include "base/double_parts.hpp"
#include "io/hash_name.hpp"

namespace ccdfuzz {

namespace {

void append_bits(std::string& bytes, double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(bits >> shift & 0xff);
}

}  // namespace

std::string content_address(const Query& query) {
  std::string bytes;
  for (const MovingPatch<double>& patch : query.patches) {
    // Kind, degrees and these flags fix how many numbers follow and what they are, so that no two
    // queries have equal bytes.
    constexpr int kHasWeights = 128, kHasTrim = 64, kIsQuaternion = 32, kIsAngle = 16, kIsSpin = 48;
    constexpr int kHasEnds = 8, kHasFaces = 8;  // a hull has no ends
    bytes += static_cast<char>(
        static_cast<int>(patch.shape.kind) | (patch.has_ends() ? kHasEnds : 0) |
        (patch.faces.empty() ? 0 : kHasFaces) | (patch.weights.empty() ? 0 : kHasWeights) |
        (patch.trim.empty() ? 0 : kHasTrim) |
        (!patch.turn                   ? 0
         : patch.turn->is_quaternion() ? kIsQuaternion
         : patch.turn->is_spin()       ? kIsSpin
                                       : kIsAngle));
    bytes += static_cast<char>(patch.shape.n);
    bytes += static_cast<char>(patch.shape.m);
    for_each_coordinate(patch, [&](double x) { append_bits(bytes, x); });
    for_each_turn_number(patch, [&](double x) { append_bits(bytes, x); });
    for (const double w : patch.weights) append_bits(bytes, w);
    if (!patch.faces.empty()) bytes += static_cast<char>(2 * patch.faces.size() + patch.one_sided);
    for (const Face& face : patch.faces) {
      for (const int corner : face) bytes += static_cast<char>(corner);
    }
    if (patch.trim.empty()) continue;
    // The number of loops, and of vertices of each, as numbers fix how many bytes follow.
    append_bits(bytes, static_cast<double>(patch.trim.size()));
    for (const auto& loop : patch.trim) {
      append_bits(bytes, static_cast<double>(loop.size()));
      for (const auto& [u, v] : loop) append_bits(bytes, u), append_bits(bytes, v);
    }
  }
  append_bits(bytes, compare(query.t_max, 0) == 0 ? 0.0 : query.t_max);  // −0 is the same horizon
  if (compare(query.separation, 0) != 0) append_bits(bytes, query.separation);
  return hash_name(bytes);
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
