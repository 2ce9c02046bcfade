#include "certify/checker/check_plane.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bezier/exact_patch.hpp"
#include "certify/checker/abbreviated.hpp"
#include "certify/checker/check_turning.hpp"
#include "certify/checker/nonnegative.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

tl::unexpected<InputError> refuse_plane(std::string what) {
  return input_error("truth.certificate.clear", std::move(what));
}

std::vector<Dyadic> along(const Vec3<Dyadic>& normal, const Points<Dyadic>& points) {
  std::vector<Dyadic> out;
  for (const Vec3<Dyadic>& p : points) out.push_back(dot(normal, p));
  return out;
}

/// Charges for all that takes control points in, at most 64 operations for each. Its numbers are
/// sums of the gap and of products of a number of the plane and a control point's, or up to three
/// of those.
void charge_for(const Query& query, const MovingPlane& plane, const Dyadic& gap, Work& work) {
  constexpr std::uint64_t kOperations = 64;
  constexpr std::uint64_t kDouble = 18;      // words of a double as a fraction
  constexpr std::uint64_t kDifference = 51;  // of two: 2,099 bits over 1,075
  std::uint64_t words = kDouble + (has_ends(query) ? kDifference : kDouble) +
                        (is_rational(query) ? kDouble : 0) + words_of(plane.until) +
                        words_of(plane.offset) + words_of(gap);
  for (const Rational& n : plane.normal) words += words_of(n);
  const std::uint64_t points =
      query.patches[0].positions.size() + query.patches[1].positions.size();
  work.charge(points * kOperations * fraction_work(words));
}

Result<void> check_plane_within(const Query& query, const MovingPlane& plane, Work& work) {
  if (plane.until < 0)
    return refuse_plane(fmt::format("until: {} is negative", abbreviated(plane.until)));
  // In units of 1/unit all numbers of the plane are integers. Their signs are what counts.
  Integer unit = lcm(plane.until.get_den(), plane.offset.get_den());
  for (const Rational& n : plane.normal) unit = lcm(unit, n.get_den());
  const auto in_units = [&](const Rational& x) { return Dyadic(Rational(x * unit).get_num(), 0); };
  const Dyadic all(unit, 0), until = in_units(plane.until), offset = in_units(plane.offset);
  Vec3<Dyadic> normal;
  for (int k = 0; k < 3; ++k) normal[k] = in_units(plane.normal[k]);
  // Patch 1 is to be beyond the plane by the separation, which is this much along the normal.
  const Dyadic separation = Dyadic::exact(query.separation);
  const Dyadic squared = separation * separation * dot(normal, normal);
  const Dyadic gap = *Dyadic::from(root_above(squared.rational(), work));
  charge_for(query, plane, gap, work);
  std::array<std::vector<Dyadic>, 2> rates;
  for (size_t s = 0; s < 2; ++s) {
    const MovingPatch<Dyadic> patch = exact_patch<Dyadic>(query.patches[s]);
    rates[s] = along(normal, patch.velocities);
    const Dyadic level = s == 0 ? offset + gap : offset;
    std::vector<Rational> heights;
    for (const Dyadic& start : along(normal, patch.positions)) {
      const Dyadic height = all * (start - level) + until * rates[s][heights.size()];
      heights.push_back((s == 0 ? height : -height).rational());
    }
    // With weights > 0 the height is ≥ 0 where its numerator is, the sum of these times B.
    for (size_t i = 0; i < patch.weights.size(); ++i) heights[i] *= patch.weights[i].rational();
    if (!is_nonnegative(patch.shape, heights, &work)) {
      return refuse_plane(fmt::format(
          "patches[{}] is not known to be on its side of the plane{}", s,
          s == 0 && query.separation > 0 ? fmt::format(" by {}", query.separation) : ""));
    }
  }
  if (*std::max_element(rates[0].begin(), rates[0].end()) >=
      *std::min_element(rates[1].begin(), rates[1].end())) {
    return refuse_plane("the patches do not both approach the plane");
  }
  return {};
}

}  // namespace

Result<void> check_plane(const Query& query, const MovingPlane& plane, std::uint64_t most_work) {
  return within_work("truth.certificate.clear", most_work, check_plane_within, query, plane);
}

}  // namespace ccdfuzz
