#include "certify/linear/first_contact.hpp"

#include <algorithm>
#include <vector>

#include "base/verify.hpp"
#include "bezier/exact_patch.hpp"
#include "certify/linear/origin_in_triangle.hpp"

namespace ccdfuzz::linear {

namespace {

using Patches = std::array<MovingPatch<Rational>, 2>;
using Corners = std::array<std::array<int, 2>, 3>;

/// The triangles that make up the set of differences.
std::vector<Corners> triangles_of(const Shape& a, const Shape& b) {
  const int na = a.control_count() - 1, nb = b.control_count() - 1;
  if (na == 1 && nb == 1) {
    return {{{{0, 0}, {1, 0}, {1, 1}}}, {{{0, 0}, {0, 1}, {1, 1}}}};
  }
  Corners corners{};
  for (int i = 0; i < 3; ++i) {
    corners[static_cast<size_t>(i)] = {std::min(i, na), std::min(i, nb)};
  }
  return {corners};
}

/// The differences, times the least common denominator of all numbers.
std::array<MovingVector, 3> differences(const Patches& patches, const Corners& corners,
                                        const Integer& denominator) {
  const auto scaled = [&](const Rational& x) {
    return Integer(denominator / x.get_den() * x.get_num());
  };
  const auto& [a, b] = patches;
  std::array<MovingVector, 3> out;
  for (size_t c = 0; c < 3; ++c) {
    const auto i = static_cast<size_t>(corners[c][0]), j = static_cast<size_t>(corners[c][1]);
    for (size_t k = 0; k < 3; ++k) {
      out[c][k] = Polynomial({scaled(a.positions[i][k]) - scaled(b.positions[j][k]),
                              scaled(a.velocities[i][k]) - scaled(b.velocities[j][k])});
    }
  }
  return out;
}

Integer common_denominator(const Patches& patches, const Rational& separation) {
  Integer all = separation.get_den();
  for (const MovingPatch<Rational>& patch : patches) {
    for (const auto* points : {&patch.positions, &patch.velocities}) {
      for (const Vec3<Rational>& p : *points) {
        for (int k = 0; k < 3; ++k) all = lcm(all, p[k].get_den());
      }
    }
  }
  return all;
}

}  // namespace

std::optional<RealRoot> first_contact(const Patches& patches, const Rational& until,
                                      const Rational& separation) {
  CCDFUZZ_VERIFY(is_linear_pair(patches[0].shape, patches[1].shape) && until >= 0);
  const Integer denominator = common_denominator(patches, separation);
  const Integer distance = Rational(separation * denominator).get_num();
  std::optional<RealRoot> first;
  for (const Corners& corners : triangles_of(patches[0].shape, patches[1].shape)) {
    const auto triangle = differences(patches, corners, denominator);
    std::optional<RealRoot> t =
        distance > 0 ? first_near(triangle, distance, until) : first_at_origin(triangle, until);
    if (t && (!first || compare(*t, *first) < 0)) first = std::move(t);
  }
  return first;
}

std::array<MovingPatch<Rational>, 2> exact_patches(const Query& query) {
  return {exact_patch<Rational>(query.patches[0]), exact_patch<Rational>(query.patches[1])};
}

std::optional<RealRoot> first_contact(const Query& query) {
  return first_contact(exact_patches(query), exact(query.t_max), exact(query.separation));
}

}  // namespace ccdfuzz::linear
