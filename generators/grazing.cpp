#include "generators/paper.hpp"

#include "generators/draw_patch.hpp"
#include "generators/exact_sum.hpp"
#include "generators/tangent_cone.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

// Tangents are multiples of 2^-18, their factors of 2^-3; the weighted mean of a deformation has 20
// bits more (motion.cpp): 2^-41, as the patches themselves have.
constexpr int kPlaneTangentBits = 18;
constexpr int kFactorBits = 4;
constexpr long kFactorUnit = -3;
constexpr int kSmall = 7;
constexpr int kTries = 64;

/// v times a power of two, its largest component in [1/2, 1); nullopt if it needs more bits.
std::optional<Vec3<Dyadic>> in_unit(const Vec3<Dyadic>& v) {
  const long top = top_of(v[largest_component(v)]);
  Vec3<Dyadic> unit;
  for (int k = 0; k < 3; ++k) {
    unit[k] = v[k].scaled(-top);
    if (unit[k].sign() != 0 && unit[k].exponent() < -kPlaneTangentBits) return std::nullopt;
  }
  return unit;
}

/// Two vectors that span the plane across `normal`, if its direction is one of few bits, as that of
/// the paper's contact planes is (Appendix E.3).
std::optional<std::array<Vec3<Dyadic>, 2>> tangents_across(const Vec3<Dyadic>& normal) {
  const int k = largest_component(normal);
  std::array<Vec3<Dyadic>, 2> tangents;
  for (int i = 0; i < 2; ++i) {
    const int axis = (k + 1 + i) % 3;
    const auto ratio = Dyadic::from(Rational(normal[axis].rational() / normal[k].rational()));
    if (!ratio) return std::nullopt;
    Vec3<Dyadic> t = {Dyadic(), Dyadic(), Dyadic()};
    t[axis] = Dyadic(1);
    t[k] = -*ratio;
    const auto unit = in_unit(t);
    if (!unit) return std::nullopt;
    tangents[static_cast<size_t>(i)] = *unit;
  }
  return tangents;
}

/// ±normal with both cones on their sides of its plane; nullopt if neither sign has them so.
std::optional<Vec3<Dyadic>> separating_sign(const std::array<TangentCone, 2>& cones,
                                            Vec3<Dyadic> normal) {
  for (int turn = 0; turn < 2; ++turn) {
    bool separates = true;
    for (size_t s = 0; s < 2; ++s) {
      const int wanted = s == 0 ? 1 : -1;
      for (const Vec3<Dyadic>& a : cones[s].sides) {
        separates = separates && dot(normal, a).sign() == wanted;
      }
    }
    if (separates) return normal;
    normal = -normal;
  }
  return std::nullopt;
}

Vec3<Dyadic> within(const GrazingPlane& plane, Draw& draw) {
  Vec3<Dyadic> v = {Dyadic(), Dyadic(), Dyadic()};
  for (const Vec3<Dyadic>& t : plane.tangent) v += t * draw.lattice(kFactorBits, kFactorUnit);
  return v;
}

}  // namespace

std::optional<GrazingPlane> grazing_plane(const std::array<Points<Dyadic>, 2>& points,
                                          const std::array<Barycentric, 2>& x,
                                          const Vec3<Dyadic>& normal, Draw& draw) {
  if (const auto tangents = tangents_across(normal)) return GrazingPlane{*tangents, normal};
  std::array<TangentCone, 2> cones;
  for (size_t s = 0; s < 2; ++s) cones[s] = tangent_cone(points[s], x[s]);
  // A face spans the plane, and so do two edges; else there is at most one line.
  std::vector<Vec3<Dyadic>> lines;
  for (const TangentCone& cone : cones) {
    if (cone.lines.size() == 2) lines = cone.lines;
  }
  if (lines.empty()) {
    for (const TangentCone& cone : cones) {
      lines.insert(lines.end(), cone.lines.begin(), cone.lines.end());
    }
  }
  const bool given = lines.size() == 2;
  lines.resize(2, Vec3<Dyadic>(Dyadic(), Dyadic(), Dyadic()));
  for (int attempt = 0; attempt < (given ? 1 : kTries); ++attempt) {
    for (Vec3<Dyadic>* line : {&lines[0], &lines[1]}) {
      const bool free = !given && (line == &lines[1] || cones[1].lines.empty());
      if (free) *line = exact_dyadic(draw_integers(draw, kSmall));
    }
    const Vec3<Dyadic> candidate = cross(lines[0], lines[1]);
    if (candidate == Vec3<Dyadic>()) continue;
    // On a face no side tells which sign is right, but static_check did.
    const bool no_side = cones[0].sides.empty() && cones[1].sides.empty();
    const auto signed_normal =
        no_side ? std::optional(dot(candidate, normal).sign() > 0 ? candidate
                                                                  : Vec3<Dyadic>(-candidate))
                : separating_sign(cones, candidate);
    if (!signed_normal) continue;
    const auto first = in_unit(lines[0]), second = in_unit(lines[1]);
    if (first && second) return GrazingPlane{{*first, *second}, *signed_normal};
  }
  return std::nullopt;
}

std::array<MovingPatch<Dyadic>, 2> set_grazing(const std::array<Points<Dyadic>, 2>& points,
                                               const PrescribedContact& contact,
                                               const GrazingPlane& plane, Draw& draw) {
  const Vec3<Dyadic> common = draw.vector(kSpeedBits, kSpeedUnit);
  const Vec3<Dyadic> slide = draw.until([&] { return within(plane, draw); },
                                        [](const Vec3<Dyadic>& v) { return v != Vec3<Dyadic>(); });
  const int up = largest_component(plane.normal);
  std::array<MovingPatch<Dyadic>, 2> patches;
  for (size_t s = 0; s < 2; ++s) {
    const std::vector<Dyadic> weights = bernstein_weights(contact.x[s]);
    Points<Dyadic> rates;
    for (size_t i = 0; i < 6; ++i) rates.push_back(within(plane, draw));
    const Vec3<Dyadic> mean = point_at(rates, contact.x[s]);
    const int towards = (s == 0 ? -1 : 1) * plane.normal[up].sign();
    MovingPatch<Dyadic>& patch = patches[s];
    patch = {kQuadratic, points[s], rates};
    for (size_t i = 0; i < 6; ++i) {
      Vec3<Dyadic>& v = patch.velocities[i];
      v += common - mean;
      if (s == 1) v += slide;
      if (weights[i].sign() == 0) {
        const Dyadic speed = abs(draw.lattice(kSpeedBits, kSpeedUnit));
        v[up] += towards > 0 ? speed : -speed;
      }
    }
    patch.positions = patch.at(-contact.t);
  }
  return patches;
}

void part(Scene& scene, int exponent) {
  const int k = largest_component(scene.normal);
  const Dyadic away(-scene.normal[k].sign(), exponent);
  for (Vec3<Dyadic>& p : scene.patches[1].positions) p[k] += away;
}

}  // namespace ccdfuzz
