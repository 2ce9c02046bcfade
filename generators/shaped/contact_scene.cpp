#include "generators/shaped/contact_scene.hpp"

#include <algorithm>
#include <bit>

#include "base/verify.hpp"
#include "bezier/blossom.hpp"
#include "certify/checker/check_plane.hpp"
#include "generators/exact_sum.hpp"
#include "generators/finalize.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

// Steps of a grid are multiples of 2^-6, velocities of 2^-8; both are below 2^2.
constexpr int kStepBits = 8;
constexpr long kStepUnit = -6;
constexpr int kRateBits = 10;
constexpr long kRateUnit = -8;

Vec3<Dyadic> planar(const Planar& p) {
  return {p[0], p[1], Dyadic()};
}

Planar random_step(Draw& draw) {
  Planar step;
  for (Dyadic& x : step) x = draw.lattice(kStepBits, kStepUnit);
  return step;
}

/// Changes each velocity by up to `ulps` of the patch's largest number in that coordinate.
void add_noise(MovingPatch<Dyadic>& patch, int ulps, Draw& draw) {
  for (int k = 0; k < 3; ++k) {
    long top = 0;
    bool any = false;
    for (const Points<Dyadic>* points : {&patch.positions, &patch.velocities}) {
      for (const Vec3<Dyadic>& p : *points) {
        if (p[k].sign() == 0) continue;
        top = any ? std::max(top, top_of(p[k])) : top_of(p[k]);
        any = true;
      }
    }
    // Positions are sums of two such numbers, one of them times t*, a half or 1: two bits more,
    // which are taken off here.
    for (Vec3<Dyadic>& v : patch.velocities) {
      v[k] += Dyadic(draw.integer(-ulps, ulps), top + 2 - 53);
    }
  }
}

MovingPlane plane_of(const ContactScene& scene, const Placement& placement,
                     const std::array<MovingPatch<Dyadic>, 2>& patches) {
  MovingPlane plane{scene.t.rational(), {}, 0};
  Vec3<Dyadic> normal;
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<size_t>(k);
    normal[k] = placement.frame.normal[k].scaled(-placement.exponent[axis]);
    plane.normal[k] = normal[k].rational();
  }
  const Vec3<Dyadic> contact =
      evaluate<Dyadic>(patches[0].shape, patches[0].positions, scene.sides[0].at);
  plane.offset = dot(normal, contact).rational();
  return plane;
}

}  // namespace

MovingPatch<Dyadic> placed(const ContactSide& side, const Placement& placement, const Dyadic& t) {
  MovingPatch<Dyadic> patch{side.shape, {}, {}};
  const auto in_space = [&](const Vec3<Dyadic>& x, const Vec3<Dyadic>& offset) {
    Vec3<Dyadic> p = point_of(placement.frame, x) + offset;
    for (int k = 0; k < 3; ++k) p[k] = p[k].scaled(placement.exponent[static_cast<size_t>(k)]);
    return p;
  };
  const Vec3<Dyadic> shift = placement.shift + placement.drift * t;
  for (const Vec3<Dyadic>& x : side.points) patch.positions.push_back(in_space(x, shift));
  for (const Vec3<Dyadic>& v : side.rates) patch.velocities.push_back(in_space(v, placement.drift));
  return patch;
}

Points<Dyadic> flat_net(const Shape& shape, bool straight, Draw& draw) {
  const auto [along_u, along_v] = draw.until(
      [&] {
        const Planar first = random_step(draw);
        return std::array{first, random_step(draw)};
      },
      [](const auto& uv) { return (uv[0][0] * uv[1][1] - uv[0][1] * uv[1][0]).sign() != 0; });
  const long shrink =
      std::bit_width(static_cast<unsigned>(std::max(1, std::max(shape.n, shape.m)))) - 1;
  Points<Dyadic> net;
  for_each_control(shape, [&](int i, int j) {
    Planar p = {along_u[0] * Dyadic(i) + along_v[0] * Dyadic(j),
                along_u[1] * Dyadic(i) + along_v[1] * Dyadic(j)};
    for (Dyadic& x : p) {
      x = x.scaled(-shrink);
      if (!straight) x += draw.lattice(kStepBits - 3, kStepUnit - shrink);
    }
    net.push_back(planar(p));
  });
  return net;
}

ContactSide flat_side(const Shape& shape, const Uv<Dyadic>& at, bool straight, Draw& draw) {
  ContactSide side{shape, at, flat_net(shape, straight, draw), {}};
  centre(side);
  return side;
}

void raise(Points<Dyadic>& points, const std::vector<Dyadic>& heights) {
  for (size_t i = 0; i < points.size(); ++i) points[i][2] += heights[i];
}

void turn_over(ContactSide& side) {
  for (Vec3<Dyadic>& p : side.points) p[2] = -p[2];
}

void centre(ContactSide& side) {
  const Vec3<Dyadic> contact = evaluate<Dyadic>(side.shape, side.points, side.at);
  for (Vec3<Dyadic>& p : side.points) p -= planar({contact[0], contact[1]});
}

void let_approach(ContactScene& scene, Draw& draw) {
  for (size_t s = 0; s < 2; ++s) {
    ContactSide& side = scene.sides[s];
    side.rates.clear();
    for (size_t i = 0; i < side.points.size(); ++i) {
      Vec3<Dyadic> rate = draw.vector(kRateBits, kRateUnit);
      rate[2] = abs(rate[2]) + Dyadic(1, kRateUnit);
      if (s == 0) rate[2] = -rate[2];
      side.rates.push_back(rate);
    }
  }
  scene.separated = true;
}

std::optional<Case> to_case(const ContactScene& scene, const Placement& placement, Draw& draw) {
  std::array<MovingPatch<Dyadic>, 2> patches;
  Case out;
  Witness witness{scene.t.rational(), {}};
  for (size_t s = 0; s < 2; ++s) {
    const ContactSide& side = scene.sides[s];
    patches[s] = placed(side, placement, scene.t);
    witness.uv[s] = {side.at[0].rational(), side.at[1].rational()};
  }
  if (scene.separated) out.truth.clearance = plane_of(scene, placement, patches);
  for (MovingPatch<Dyadic>& patch : patches) {
    if (placement.noise_ulps > 0) add_noise(patch, placement.noise_ulps, draw);
    patch.positions = patch.at(-scene.t);
  }
  const std::optional<Query> query = to_query(patches, scene.t_max);
  if (!query) return std::nullopt;
  out.query = *query;
  if (!scene.touches) return out;
  say_contact(out, witness);
  if (scene.separated) {
    CCDFUZZ_VERIFY(check_plane(out.query, std::get<MovingPlane>(*out.truth.clearance)));
    out.truth.clear_until = witness.t;
  }
  return out;
}

}  // namespace ccdfuzz
