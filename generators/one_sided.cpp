#include "generators/one_sided.hpp"

#include "generators/frame.hpp"
#include "generators/prescribe.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

// Units. All draws are integers times these powers of two; the finest bit of a regular case:
//   contact point     2^-41, up to 2^5
//   T · τ             T integers < 2^5 times τ: 2^-13 .. 2^-1 with Σβτ = 0 to 2^-37 (β has 24 bits)
//   height · m        m integers < 2^5 times 2^-8-f · (integers < 2^7 to 2^-24, as parameters are
//                     squared): 2^-44 for flatness f ≤ 12
// so that every position is a multiple of 2^-44 below 2^8: 52 of a double's 53 bits.
constexpr long kTangentUnit = -13;
constexpr int kSlopeBits = 2;  // of the linear factors of a height
constexpr long kHeightUnit = -8;
constexpr int kVelocityBits = 17;
constexpr long kVelocityUnit = -15;

/// A linear function on the triangle that is 0 at x, by its values at the corners.
Barycentric linear_through(const Barycentric& x, Draw& draw) {
  Barycentric r;
  Dyadic at_x;
  for (size_t a = 0; a < 3; ++a) {
    r[a] = draw.lattice(kSlopeBits, 0);
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
///   edge    p² along the edge, p linear through x (0 if it is a flat edge), and positive
///           coefficients off it
///   corner  0 at the corner, positive coefficients elsewhere
/// All times 2^unit.
std::array<Dyadic, 6> one_sided_heights(const Barycentric& x, bool flat_edge, long unit,
                                        Draw& draw) {
  const Feature feature = feature_at(x);
  Barycentric p, q;
  if (feature == Feature::kFace) {
    const auto both = draw.until(
        [&] {
          const Barycentric first = linear_through(x, draw);
          return std::array{first, linear_through(x, draw)};
        },
        [](const auto& pq) {  // they are independent: both vanish at x, where no coordinate is 0
          return (pq[0][0] * pq[1][1] - pq[0][1] * pq[1][0]).sign() != 0;
        });
    p = both[0];
    q = both[1];
  } else if (feature == Feature::kEdge && !flat_edge) {
    p = draw.until([&] { return linear_through(x, draw); },
                   [&](const Barycentric& r) { return !is_zero_on(r, x); });
  }
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
      h = Dyadic(static_cast<int>(draw.integer(1, 1 << (2 * kSlopeBits + 2))));
    }
    heights[i] = h.scaled(unit);
  }
  return heights;
}

/// A velocity with a positive normal part.
Vec3<Dyadic> upward_velocity(const Vec3<Dyadic>& normal, Draw& draw) {
  const auto side = [&](const Vec3<Dyadic>& r) { return dot(normal, r).sign(); };
  const Vec3<Dyadic> r = draw.until([&] { return draw.vector(kVelocityBits, kVelocityUnit); },
                                    [&](const Vec3<Dyadic>& v) { return side(v) != 0; });
  return side(r) > 0 ? r : Vec3<Dyadic>(-r);
}

Vec3<Dyadic> tangential_velocity(const PlaneFrame& frame, Draw& draw) {
  Vec3<Dyadic> v = {Dyadic(), Dyadic(), Dyadic()};
  for (const Vec3<Dyadic>& t : frame.tangent) v += t * draw.lattice(kTangentBits, kTangentUnit);
  return v;
}

}  // namespace

Scene one_sided_scene(ContactClass contact, const OneSidedStyle& style, Draw& draw) {
  const std::array<Feature, 2> features = features_of(contact);
  const PlaneFrame frame = random_frame(draw);
  Scene scene;
  scene.contact.t = style.t;
  scene.t_max = style.t_max;
  scene.normal = frame.normal;
  Vec3<Dyadic> point = draw.vector(style.contact_bits, style.contact_unit);
  if (style.plane_through_origin) {
    point = Vec3<Dyadic>(frame.tangent[0] * point[0] + frame.tangent[1] * point[1]);
  }
  const Vec3<Dyadic> common =
      style.grazing ? tangential_velocity(frame, draw) : draw.vector(kVelocityBits, kVelocityUnit);
  for (size_t s = 0; s < 2; ++s) {
    const int bits = static_cast<int>(draw.integer(2, style.max_parameter_bits));
    const Barycentric x = prescribe_anywhere(features[s], bits, draw);
    scene.contact.x[s] = x;
    const std::array<Planar, 6> tau = tangential_part(bernstein_weights(x), kTangentUnit, draw);
    // An edge of EE and VE may lie in the contact plane, where it crosses the other's contact
    // point.
    const bool flat_edge = style.flat_edges && features[1] == Feature::kEdge && draw.below(4) != 0;
    const std::int64_t flatness = draw.integer(style.min_flatness, style.max_flatness);
    const std::array<Dyadic, 6> heights =
        one_sided_heights(x, flat_edge, kHeightUnit - static_cast<long>(flatness), draw);
    MovingPatch<Dyadic>& patch = scene.patches[s];
    patch = {kQuadratic, Points<Dyadic>(6), Points<Dyadic>(6)};
    for (size_t i = 0; i < 6; ++i) {
      const Dyadic side(s == 0 ? 1 : -1);
      const Vec3<Dyadic> away =
          style.grazing ? tangential_velocity(frame, draw) : upward_velocity(frame.normal, draw);
      const Vec3<Dyadic> at_contact = point + point_of(frame, tau[i], side * heights[i]);
      patch.velocities[i] = common - away * side;
      patch.positions[i] = at_contact - patch.velocities[i] * style.t;
    }
  }
  return scene;
}

}  // namespace ccdfuzz
