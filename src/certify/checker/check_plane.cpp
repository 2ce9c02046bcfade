#include "certify/checker/check_plane.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bezier/exact_patch.hpp"
#include "certify/checker/abbreviated.hpp"
#include "certify/checker/nonnegative.hpp"

namespace ccdfuzz {

namespace {

tl::unexpected<InputError> refuse_plane(std::string what) {
  return input_error("truth.certificate.clear", std::move(what));
}

std::vector<Rational> along(const std::array<Rational, 3>& normal, const Points<Rational>& points) {
  std::vector<Rational> out;
  for (const Vec3<Rational>& p : points) {
    out.emplace_back(normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2]);
  }
  return out;
}

/// Charges for all of the check. Its numbers are sums of products of a number of the plane and a
/// control point's, or up to three of those. At most 64 operations take a control point in.
void charge_for(const Query& query, const MovingPlane& plane, Work& work) {
  constexpr std::uint64_t kOperations = 64;
  constexpr std::uint64_t kDouble = 18;      // words of a double as a fraction
  constexpr std::uint64_t kDifference = 51;  // of two: 2,099 bits over 1,075
  std::uint64_t words = kDouble + (has_ends(query) ? kDifference : kDouble) +
                        (is_rational(query) ? kDouble : 0) + words_of(plane.until) +
                        words_of(plane.offset);
  for (const Rational& n : plane.normal) words += words_of(n);
  const std::uint64_t points =
      query.patches[0].positions.size() + query.patches[1].positions.size();
  work.charge(points * kOperations * fraction_work(words));
}

Result<void> check_within(const Query& query, const MovingPlane& plane, Work& work) {
  charge_for(query, plane, work);
  if (query.separation > 0) {
    return refuse_plane(
        fmt::format("a plane proves nothing of distances up to {}", query.separation));
  }
  if (plane.until < 0)
    return refuse_plane(fmt::format("until: {} is negative", abbreviated(plane.until)));
  std::array<std::vector<Rational>, 2> rates;
  for (size_t s = 0; s < 2; ++s) {
    const MovingPatch<Rational> patch = exact_patch<Rational>(query.patches[s]);
    rates[s] = along(plane.normal, patch.velocities);
    std::vector<Rational> heights = along(plane.normal, patch.at(plane.until));
    for (Rational& h : heights)
      h = s == 0 ? Rational(h - plane.offset) : Rational(plane.offset - h);
    // With weights > 0 the height is ≥ 0 where its numerator is, the sum of these times B.
    for (size_t i = 0; i < patch.weights.size(); ++i) heights[i] *= patch.weights[i];
    if (!is_nonnegative(patch.shape, heights, &work)) {
      return refuse_plane(
          fmt::format("patches[{}] is not known to be on its side of the plane", s));
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
  return within_work("truth.certificate.clear", most_work,
                     [&](Work& work) { return check_within(query, plane, work); });
}

}  // namespace ccdfuzz
