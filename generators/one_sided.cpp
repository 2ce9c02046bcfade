#include "generators/one_sided.hpp"

#include "generators/prescribe.hpp"

namespace ccdfuzz {

namespace {

// Units. All draws are integers times these powers of two; the resulting bits of a position are
// counted from the finest one to show that a double holds them:
//   contact point     2^-41 .. 2^5
//   T · τ             T integers < 2^5 times τ: 2^-13 .. 2^-2 with Σβτ = 0 to 2^-25 (β has 12 bits)
//   height · m        m integers < 2^5 times 2^-16-f·(integers), contact parameters squared 2^-12:
//                     finest 2^-40 for flatness f ≤ 12
// so that every position is a multiple of 2^-41 below 2^7: 48 bits, one more after − t*·v.
constexpr int kContactBits = 46;
constexpr long kContactUnit = -41;
constexpr int kFrameBound = 31;
constexpr int kTangentBits = 11;
constexpr long kTangentUnit = -13;
constexpr int kSlopeBits = 6;  // of the linear factors of a height
constexpr long kHeightUnit = -16;
constexpr int kMaxFlatness = 12;
constexpr int kVelocityBits = 17;
constexpr long kVelocityUnit = -15;

/// The contact plane and a direction out of it.
struct Frame {
  std::array<Vec3<Dyadic>, 2> tangent;
  Vec3<Dyadic> out;
  Vec3<Dyadic> normal;  ///< tangent[0] × tangent[1]; normal·out > 0
};

Vec3<Dyadic> integer_vector(Random& random) {
  Vec3<Dyadic> v;
  for (int k = 0; k < 3; ++k) {
    v[k] = Dyadic(static_cast<int>(random.between(-kFrameBound, kFrameBound)));
  }
  return v;
}

Frame random_frame(Random& random) {
  Frame frame;
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

using Planar = std::array<Dyadic, 2>;

/// a·b' − a'·b
Dyadic area(const Planar& a, const Planar& b) {
  return a[0] * b[1] - a[1] * b[0];
}

Planar difference(const Planar& a, const Planar& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

/// Tangential control points: a triangle that is not degenerate, mid controls off its edge
/// midpoints by up to an eighth, shifted so that Σ β τ = 0.
std::array<Planar, 6> tangential_part(const std::array<Dyadic, 6>& weights, Random& random) {
  std::array<Planar, 3> corner;
  do {
    for (Planar& p : corner) {
      for (Dyadic& x : p) x = random.dyadic(kTangentBits, kTangentUnit);
    }
  } while (area(difference(corner[1], corner[0]), difference(corner[2], corner[0])).sign() == 0);
  std::array<Planar, 6> tau;
  Planar mean;
  for (size_t i = 0; i < 6; ++i) {
    const auto [a, b] = kCornerPairs[i];
    for (size_t k = 0; k < 2; ++k) {
      tau[i][k] = (corner[a][k] + corner[b][k]).scaled(-1);
      if (a != b) tau[i][k] += random.dyadic(kTangentBits - 3, kTangentUnit);
      mean[k] += weights[i] * tau[i][k];
    }
  }
  for (Planar& p : tau) p = difference(p, mean);
  return tau;
}

/// A linear function on the triangle that is 0 at x, by its values at the corners.
Barycentric linear_through(const Barycentric& x, Random& random) {
  Barycentric r;
  Dyadic at_x;
  for (size_t a = 0; a < 3; ++a) {
    r[a] = random.dyadic(kSlopeBits, 0);
    at_x += r[a] * x[a];
  }
  for (Dyadic& value : r) value -= at_x;
  return r;
}

bool is_zero_on(const Barycentric& r, const Barycentric& x) {
  for (size_t a = 0; a < 3; ++a) {
    if (x[a].sign() != 0 && r[a].sign() != 0) return false;
  }
  return true;
}

/// Heights that are 0 at x and positive elsewhere on the triangle:
///   face    p² + q² for independent linear functions p, q through x
///   edge    p² along the edge, p linear through x, and positive coefficients off it
///   corner  0 at the corner, positive coefficients elsewhere
std::array<Dyadic, 6> one_sided_heights(const Barycentric& x, Random& random) {
  const Feature feature = feature_at(x);
  Barycentric p, q;
  if (feature == Feature::kFace) {
    Dyadic independent;
    while (independent.sign() == 0) {
      p = linear_through(x, random);
      q = linear_through(x, random);
      independent = p[0] * q[1] - p[1] * q[0];  // both vanish at x, where no coordinate is 0
    }
  } else if (feature == Feature::kEdge) {
    do {
      p = linear_through(x, random);
    } while (is_zero_on(p, x));
  }
  const long unit = kHeightUnit - static_cast<long>(random.between(0, kMaxFlatness));
  std::array<Dyadic, 6> heights;
  for (size_t i = 0; i < 6; ++i) {
    const auto [a, b] = kCornerPairs[i];
    const bool on_feature = x[a].sign() != 0 && x[b].sign() != 0;
    Dyadic h;
    if (feature == Feature::kFace) {
      h = p[a] * p[b] + q[a] * q[b];
    } else if (feature == Feature::kEdge && on_feature) {
      h = p[a] * p[b];
    } else if (!on_feature) {
      h = Dyadic(static_cast<int>(random.between(1, std::int64_t{1} << (2 * kSlopeBits))));
    }
    heights[i] = h.scaled(unit);
  }
  return heights;
}

/// A velocity with a positive normal part.
Vec3<Dyadic> upward_velocity(const Vec3<Dyadic>& normal, Random& random) {
  for (;;) {
    const Vec3<Dyadic> r = random.vector(kVelocityBits, kVelocityUnit);
    const int side = dot(normal, r).sign();
    if (side != 0) return side > 0 ? r : Vec3<Dyadic>(-r);
  }
}

}  // namespace

Scene one_sided_scene(ContactClass contact, Random& random) {
  const std::array<Feature, 2> features = features_of(contact);
  Scene scene;
  scene.contact.t = Dyadic(1);
  const Frame frame = random_frame(random);
  scene.normal = frame.normal;
  const Vec3<Dyadic> point = random.vector(kContactBits, kContactUnit);
  const Vec3<Dyadic> common = random.vector(kVelocityBits, kVelocityUnit);
  for (size_t s = 0; s < 2; ++s) {
    const Barycentric x = prescribe_anywhere(features[s], random);
    scene.contact.x[s] = x;
    const std::array<Planar, 6> tau = tangential_part(bernstein_weights(x), random);
    const std::array<Dyadic, 6> heights = one_sided_heights(x, random);
    MovingPatch<Dyadic>& patch = scene.patches[s];
    patch = {kQuadratic, Points<Dyadic>(6), Points<Dyadic>(6)};
    for (size_t i = 0; i < 6; ++i) {
      const Vec3<Dyadic> upward = upward_velocity(frame.normal, random);
      const Dyadic side(s == 0 ? 1 : -1);
      const Vec3<Dyadic> at_contact = point + frame.tangent[0] * tau[i][0] +
                                      frame.tangent[1] * tau[i][1] +
                                      frame.out * (side * heights[i]);
      patch.velocities[i] = common - upward * side;
      patch.positions[i] = at_contact - patch.velocities[i] * scene.contact.t;
    }
  }
  return scene;
}

}  // namespace ccdfuzz
