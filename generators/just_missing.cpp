#include "generators/just_missing.hpp"

#include <cmath>

#include "case/scale.hpp"
#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {

namespace {

/// Moves a body along a way by the shortest step that there is. False if there is none.
bool step_along(const Vec3<double>& way, MovingPatch<double>& body, const Query& query) {
  constexpr int kFloatBits = 24;
  const Points<double> before = body.positions;
  const int most = std::ilogb(largest_coordinate(query));
  for (int exponent = most + 1 - kFloatBits; exponent < most; ++exponent) {
    const Vec3<double> step = way * std::ldexp(1.0, exponent);
    for (size_t i = 0; i < before.size(); ++i) body.positions[i] = before[i] + step;
    if (is_binary32(query)) return true;
  }
  return false;
}

}  // namespace

Attempted just_missing(Case grazing, Draw& draw) {
  const Vec3<Rational> normal = std::get<BodyClearance>(*grazing.truth.clearance).normal;
  Integer common = 0;
  for (const Rational& x : normal) common = gcd(common, x.get_num());
  const size_t side = draw.below(2);
  Vec3<double> way;
  for (int k = 0; k < 3; ++k) {
    const Integer part = normal[k].get_num() / common;
    way[k] = side == 1 ? part.get_d() : -part.get_d();
  }
  Query& query = grazing.query;
  if (!step_along(way, query.patches[side], query)) return tl::unexpected(Discard::kRoundTrip);
  grazing.truth = decide(query, {.apart_along = normal}).truth;
  if (grazing.truth.collides != false) return tl::unexpected(Discard::kFirstContact);
  return grazing;
}

}  // namespace ccdfuzz
