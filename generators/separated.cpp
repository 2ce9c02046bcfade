#include "generators/separated.hpp"

#include <cmath>

#include "certify/oracle/rational_roots.hpp"
#include "generators/elsewhere.hpp"
#include "generators/shaped/families.hpp"
#include "generators/shaped/shaped_case.hpp"
#include "generators/weighted.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

bool move_apart(Query& query, const Vec3<Dyadic>& way) {
  if (!add_exactly(query.patches[0].positions, way)) return false;
  query.separation = round_up(root_above(dot(way, way).rational()));
  return true;
}

/// A regular or interior-time contact whose patch 1 is moved along the normal by the separation.
/// The normal's length is a whole number, so that its plane proves all times before.
Attempted separated_case(const GeneratorOptions& options, Draw& draw) {
  const Family family = draw.coin() ? Family::kInteriorTime : Family::kRegular;
  const auto make = std::get<FamilyRow::Make*>(row_of(family).made_by);
  PlacedScene placed = make(options.contact, shapes_of(options, draw), draw);
  placed.placement.frame = whole_normal_frame(draw);
  std::optional<Case> made = to_case(placed.scene, placed.placement, draw);
  if (!made) return tl::unexpected(Discard::kRoundTrip);
  const auto& plane = std::get<MovingPlane>(*made->truth.clearance);
  // From 2^-20 to 2^-8 of the size of the scene, as simulations keep meshes apart. The larger a
  // separation is, the more pairs of points are nearly as near as the nearest.
  int exponent = size_exponent(made->query) - 1 - draw.integer(8, 20);
  Vec3<Dyadic> way;
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const std::optional<Dyadic> along = Dyadic::from(plane.normal[static_cast<std::size_t>(k)]);
    if (!along) return tl::unexpected(Discard::kRoundTrip);
    way[k] = *along;
    longest = std::max(longest, std::abs(along->rational().get_d()));
  }
  exponent -= std::ilogb(longest);
  if (!move_apart(made->query, way * Dyadic(1, exponent))) {
    return tl::unexpected(Discard::kRoundTrip);
  }
  return as_asked(*std::move(made), options);
}

}  // namespace ccdfuzz
