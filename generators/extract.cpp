#include "generators/paper.hpp"

#include <algorithm>
#include <bit>

#include "generators/differential.hpp"
#include "generators/shaped/features.hpp"

namespace ccdfuzz {

namespace {

constexpr long kGridUnit = -kGridBits;

/// x + step·d, d in grid units.
Barycentric offset(const Barycentric& x, const std::array<std::int64_t, 3>& d) {
  Barycentric y = x;
  for (size_t a = 0; a < 3; ++a) y[a] += Dyadic(Integer(static_cast<long>(d[a])), kGridUnit);
  return y;
}

bool inside(const Barycentric& x) {
  return std::all_of(x.begin(), x.end(), [](const Dyadic& c) { return c.sign() >= 0; });
}

/// The largest offset of a corner, in grid units.
std::int64_t random_reach(Draw& draw) {
  return std::int64_t{1} << draw.integer(kGridBits - 6, kGridBits - 3);
}

/// True iff the triangle of these corners is not degenerate.
bool spans(const std::array<Barycentric, 3>& c) {
  const Barycentric d = towards(c[0], c[1]), e = towards(c[0], c[2]);
  return (d[0] * e[1] - d[1] * e[0]).sign() != 0;
}

using Grid2 = std::array<std::int64_t, 2>;

/// Corners x + d_a with Σ λ_a d_a = 0. λ_0 is 1/2 or 1/4, λ_1 and λ_2 are eighths; as d_1 and d_2
/// are multiples of 4, d_0 = −(λ_1 d_1 + λ_2 d_2)/λ_0 is on the grid.
LocalPatch around_interior_point(const Barycentric& x, Draw& draw) {
  const auto make = [&] {
    LocalPatch part;
    const int first = draw.coin() ? 4 : 2;  // λ in eighths
    const int second = draw.integer(1, 8 - first - 1);
    const std::array<int, 3> lambda = {first, second, 8 - first - second};
    const std::int64_t reach = random_reach(draw) / 4;
    std::array<Grid2, 3> d{};
    for (size_t a = 1; a < 3; ++a) {
      for (std::int64_t& component : d[a]) component = 4 * draw.integer(-reach, reach);
    }
    for (size_t k = 0; k < 2; ++k) {
      d[0][k] = -(lambda[1] * d[1][k] + lambda[2] * d[2][k]) / lambda[0];
    }
    for (size_t a = 0; a < 3; ++a) {
      part.corners[a] = offset(x, {d[a][0], d[a][1], -d[a][0] - d[a][1]});
      part.x[a] = Dyadic(lambda[a], -3);
    }
    return part;
  };
  return draw.until(make, [](const LocalPatch& part) {
    return std::all_of(part.corners.begin(), part.corners.end(), inside) && spans(part.corners);
  });
}

/// x is the midpoint of an edge; it divides the part's edge as j : 2^b − j.
LocalPatch around_edge_point(const Barycentric& x, Draw& draw) {
  const int k = corner_opposite(x), a = (k + 1) % 3, b = (k + 2) % 3;
  const std::int64_t reach = random_reach(draw);
  const int bits = draw.integer(1, static_cast<int>(std::bit_width(std::uint64_t(reach))) - 1);
  const std::int64_t steps = std::int64_t{1} << bits;
  const std::int64_t step = draw.integer(1, reach / steps);
  const std::int64_t j = draw.integer(1, steps - 1);
  const std::int64_t inward = draw.integer(1, reach);
  const std::int64_t along = draw.integer(-reach, reach);
  LocalPatch part;
  const auto on_edge = [&](std::int64_t to_a) {
    std::array<std::int64_t, 3> d{};
    d[a] = to_a;
    d[b] = -to_a;
    return offset(x, d);
  };
  part.corners[0] = on_edge((steps - j) * step);
  part.corners[1] = on_edge(-j * step);
  std::array<std::int64_t, 3> d{};
  d[k] = inward;
  d[a] = along;
  d[b] = -along - inward;
  part.corners[2] = offset(x, d);  // inside: x_a = x_b = 1/2 and the reach is at most 1/8
  part.x = {Dyadic(Integer(j), -bits), Dyadic(Integer(steps - j), -bits), Dyadic()};
  return part;
}

LocalPatch around_corner(const Barycentric& x, Draw& draw) {
  const int k = corner_of(x);
  const std::int64_t reach = random_reach(draw);
  LocalPatch part;
  part.x = corner_point(0);
  part.corners = draw.until(
      [&] {
        std::array<Barycentric, 3> corners;
        corners[0] = x;
        for (size_t c = 1; c < 3; ++c) {
          std::array<std::int64_t, 3> d{};
          d[(k + 1) % 3] = draw.integer(0, reach);
          d[(k + 2) % 3] = draw.integer(0, reach);
          d[k] = -d[(k + 1) % 3] - d[(k + 2) % 3];
          corners[c] = offset(x, d);
        }
        return corners;
      },
      spans);
  return part;
}

}  // namespace

LocalPatch choose_local_patch(const Barycentric& x, Draw& draw) {
  constexpr std::array kAround = {around_interior_point, around_edge_point, around_corner};
  LocalPatch part = kAround[static_cast<size_t>(feature_at(x))](x, draw);
  // Which corner of the part is u, v and w is drawn last, so that contacts lie on all three edges
  // and at all three corners.
  for (size_t a = 2; a > 0; --a) {
    const size_t b = draw.below(a + 1);
    std::swap(part.corners[a], part.corners[b]);
    std::swap(part.x[a], part.x[b]);
  }
  return part;
}

Points<Dyadic> extract(const Points<Dyadic>& parent, const LocalPatch& part) {
  Points<Dyadic> points;
  for (const auto& [a, b] : kCornerPairs) {
    points.push_back(bend(parent, part.corners[a], part.corners[b]));
  }
  return points;
}

}  // namespace ccdfuzz
