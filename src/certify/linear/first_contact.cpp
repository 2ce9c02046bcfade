#include "certify/linear/first_contact.hpp"

#include <algorithm>
#include <vector>

#include "base/verify.hpp"
#include "bezier/bernstein.hpp"
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

Integer common_denominator(const Patches& patches) {
  Integer all = 1;
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

std::optional<FirstContact> first_contact(const Patches& patches, const Rational& until) {
  CCDFUZZ_VERIFY(is_linear_pair(patches[0].shape, patches[1].shape) && until >= 0);
  const Integer denominator = common_denominator(patches);
  std::optional<FirstContact> first;
  for (const Corners& corners : triangles_of(patches[0].shape, patches[1].shape)) {
    const OriginInTriangle triangle(differences(patches, corners, denominator));
    std::optional<RealRoot> t = triangle.first(until);
    if (t && (!first || compare(*t, first->time) < 0)) first = {*std::move(t), corners};
  }
  return first;
}

std::array<MovingPatch<Rational>, 2> exact_patches(const Query& query) {
  return {exact_patch<Rational>(query.patches[0]), exact_patch<Rational>(query.patches[1])};
}

std::optional<FirstContact> first_contact(const Query& query) {
  return first_contact(exact_patches(query), exact(query.t_max));
}

std::array<Uv<Rational>, 2> parameters_at(const Patches& patches, const Corners& corners,
                                          const Rational& t) {
  const Points<Rational> a = patches[0].at(t), b = patches[1].at(t);
  std::array<Vec3<Rational>, 3> differences;
  for (size_t c = 0; c < 3; ++c) {
    const auto i = static_cast<size_t>(corners[c][0]), j = static_cast<size_t>(corners[c][1]);
    for (int k = 0; k < 3; ++k) differences[c][k] = a[i][k] - b[j][k];
  }
  const std::array<Rational, 3> weights = weights_of_origin(differences);
  std::array<Uv<Rational>, 2> uv;
  for (size_t s = 0; s < 2; ++s) {
    // Control points 0, 1, 2 of a triangle are its corners w, v, u; of a curve its ends 0 and 1.
    const bool is_triangle = patches[s].shape.kind == ShapeKind::kTriangle;
    uv[s] = {0, 0};
    for (size_t c = 0; c < 3; ++c) {
      const int place = corners[c][s];
      if (place > 0) uv[s][is_triangle && place == 1 ? 1 : 0] += weights[c];
    }
    uv[s] = parameters_with_weights(patches[s].shape, patches[s].weights, uv[s]);
  }
  return uv;
}

}  // namespace ccdfuzz::linear
