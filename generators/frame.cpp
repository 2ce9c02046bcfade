#include "generators/frame.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

Vec3<Dyadic> integer_vector(Random& random) {
  Vec3<Dyadic> v;
  for (int k = 0; k < 3; ++k) {
    v[k] = Dyadic(static_cast<int>(random.between(-kFrameBound, kFrameBound)));
  }
  return v;
}

/// a·b' − a'·b
Dyadic area(const Planar& a, const Planar& b) {
  return a[0] * b[1] - a[1] * b[0];
}

Planar difference(const Planar& a, const Planar& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

}  // namespace

PlaneFrame random_frame(Random& random) {
  PlaneFrame frame;
  const Vec3<Dyadic> zero = {Dyadic(), Dyadic(), Dyadic()};
  do {
    for (Vec3<Dyadic>& t : frame.tangent) t = integer_vector(random);
    frame.normal = cross(frame.tangent[0], frame.tangent[1]);
  } while (frame.normal == zero);
  int side = 0;
  while (side == 0) {
    frame.out = integer_vector(random);
    side = dot(frame.normal, frame.out).sign();
  }
  if (side < 0) frame.out = -frame.out;
  return frame;
}

std::array<Planar, 6> tangential_part(const std::array<Dyadic, 6>& weights, long unit,
                                      Random& random) {
  std::array<Planar, 3> corner;
  do {
    for (Planar& p : corner) {
      for (Dyadic& x : p) x = random.dyadic(kTangentBits, unit);
    }
  } while (area(difference(corner[1], corner[0]), difference(corner[2], corner[0])).sign() == 0);
  std::array<Planar, 6> tau;
  Planar mean;
  for (size_t i = 0; i < 6; ++i) {
    const auto [a, b] = kCornerPairs[i];
    for (size_t k = 0; k < 2; ++k) {
      tau[i][k] = (corner[a][k] + corner[b][k]).scaled(-1);
      if (a != b) tau[i][k] += random.dyadic(kTangentBits - 3, unit);
      mean[k] += weights[i] * tau[i][k];
    }
  }
  for (Planar& p : tau) p = difference(p, mean);
  return tau;
}

}  // namespace ccdfuzz
