#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "base/enum_names.hpp"
#include "case/case.hpp"

namespace ccdfuzz {

/// How convincing a query is that shows a failure: the last of these that applies. It is part of
/// the failure, so that shrinking cannot slide from an ordinary query into a trivial one.
enum class Setting : std::uint8_t {
  kOrdinary,
  kAtAnEnd,   ///< the contact is nearer to an end of [0, t_max] than kEndShare of it, or t_max is 0
  kSliding,   ///< bodies that approach by less than kThinnest of their way, unless a mesh is passed
              ///< through by as much of the size later on. Or linear patches whose
              ///< touching points move along the surfaces: but for kThinnest of their way they stay
              ///< in the plane or line of both
  kTouching,  ///< linear patches that touch at t = 0 already. Or a face of a one-sided mesh is
              ///< touched then, from behind or in front
  kDegenerate,  ///< at the start or at the contact a patch is as good as a point, or a surface as a
                ///< line (kThinnest). Or a body of three points or more is flatter than its count
                ///< promises in space, or in the plane z = 0 if both are there (is_in_plane). Or it
                ///< has a point twice. Or nothing moves against the rest
  kExtreme,     ///< a number that is not 0 lies outside 2^±kOrdinaryScale
};
constexpr std::array<std::string_view, 6> names_of(Setting) {
  return {"ordinary", "at an end", "sliding", "touching at 0", "degenerate", "extreme"};
}
inline constexpr auto kAllSettings = all_of(Setting{});
/// Below this no sum or product of a few coordinates and times under- or overflows.
inline constexpr int kOrdinaryScale = 40;
/// What is taken for the end of a step: a thousandth of it, which no code that steps by time tells
/// from the next step.
inline constexpr double kEndShare = 0x1p-10;
/// A surface that is narrower than this share of its length counts as a line: meshes that people
/// simulate are wider.
inline constexpr double kThinnest = 0x1p-10;

Setting setting_of(const Case& value);

/// Whether the query has a body of four points or more in one plane.
bool has_flat_body(const Query& query);

/// Whether linear patches touch, but pass less than kThinnest of their size through each other by
/// t_max (feature_depth): at the edge of a face, for one. A little motion avoids the contact.
bool is_shallow(const Case& value);

}  // namespace ccdfuzz
