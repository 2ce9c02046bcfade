#include "certify/checker/check_plane.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "certify/checker/nonnegative.hpp"
#include "certify/checker/shown.hpp"

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

}  // namespace

Result<void> check_plane(const Query& query, const MovingPlane& plane) {
  if (plane.until < 0)
    return refuse_plane(fmt::format("until: {} is negative", shown(plane.until)));
  std::array<std::vector<Rational>, 2> rates;
  for (size_t s = 0; s < 2; ++s) {
    const MovingPatch<Rational> patch = exact_patch<Rational>(query.patches[s]);
    rates[s] = along(plane.normal, patch.velocities);
    std::vector<Rational> heights = along(plane.normal, patch.at(plane.until));
    for (Rational& h : heights)
      h = s == 0 ? Rational(h - plane.offset) : Rational(plane.offset - h);
    if (!is_nonnegative(patch.shape, heights)) {
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

}  // namespace ccdfuzz
