#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/enum_names.hpp"
#include "case/query.hpp"

namespace ccdfuzz {

/// Which radii a kind of bodies has.
enum class RadiusRule : std::uint8_t { kAny, kZero, kPositive };
constexpr std::array<std::string_view, 3> names_of(RadiusRule) {
  return {"any", "zero", "positive"};
}

/// Bodies that an engine has a shape for: hulls of so many points, with such a radius.
struct BodyKind {
  std::uint32_t least_points = 1, most_points = kMaxControls;
  RadiusRule radius = RadiusRule::kAny;

  bool has(std::size_t points, bool is_round) const {
    return least_points <= points && points <= most_points &&
           (radius == RadiusRule::kAny || is_round == (radius == RadiusRule::kPositive));
  }
};
using BodyKinds = std::vector<BodyKind>;

/// Whether a body is of one of the kinds; of none given, any is.
inline bool is_one_of(const BodyKinds& kinds, std::size_t points, bool is_round) {
  return kinds.empty() || std::ranges::any_of(kinds, [&](const BodyKind& kind) {
           return kind.has(points, is_round);
         });
}

}  // namespace ccdfuzz
