#include "method/plugin/plugin_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "case/scale.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

namespace {

/// A tolerance in a larger unit: of none, none; of what overflows, the largest.
double scaled(double tolerance, double unit) {
  return tolerance == 0 ? 0 : std::min(tolerance * unit, std::numeric_limits<double>::max());
}

}  // namespace

AnswerTerms terms_of(const PluginDescription& claims, const PluginAnswer& given,
                     const Query& query) {
  AnswerTerms terms;
  terms.closed_t_max = claims.closed_t_max;
  terms.contact_at_zero = claims.contact_at_zero;
  terms.in_plane = claims.domain.plane;
  const bool in_space = claims.tolerance_kind == ToleranceKind::kSpace ||
                        claims.tolerance_kind == ToleranceKind::kSpaceRelative;
  double tolerance = claims.tolerance;
  if (given.tolerance < claims.tolerance) tolerance = given.tolerance;  // NaN: as claimed
  if (claims.tolerance_kind == ToleranceKind::kTimeRelative) {
    tolerance = scaled(tolerance, query.t_max);
  }
  if (claims.tolerance_kind == ToleranceKind::kSpaceRelative) {
    tolerance = scaled(tolerance, largest_coordinate_at_ends(query));
  }
  terms.space_tolerance = std::min(claims.minimum_separation + (in_space ? tolerance : 0),
                                   std::numeric_limits<double>::max());
  // It is not told this separation: it may keep what the claim has beyond it, rounded up.
  if (is_kept(query.separation, claims.features)) {
    terms.space_tolerance = round_up(exact(terms.space_tolerance) - exact(query.separation));
  }
  if (!in_space) terms.early_tolerance = tolerance;
  if (claims.conservative) {
    terms.kept_separation = claims.minimum_separation;
  } else {
    terms.depth_tolerance = terms.space_tolerance;
    if (!in_space) terms.time_tolerance = tolerance;
  }
  return terms;
}

std::optional<MethodFault> broken_tolerance(const PluginDescription& claims,
                                            const PluginAnswer& given) {
  if (claims.tolerance == 0 || !(given.tolerance > claims.tolerance)) return std::nullopt;
  return MethodFault(
      "broken claim",
      fmt::format("claims a tolerance of {} ({}), and answers with one of {}", claims.tolerance,
                  name_of(claims.tolerance_kind), given.tolerance));
}

}  // namespace ccdfuzz
