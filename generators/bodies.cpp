#include "generators/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "case/mesh.hpp"
#include "case/scale.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/attempts.hpp"
#include "generators/just_missing.hpp"
#include "generators/prescribe.hpp"
#include "generators/shaped/families.hpp"
#include "generators/whole_frame.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// Whole numbers, the second of them 0 in a plane: no part of a body leaves it by that axis.
Whole draw_whole(bool in_plane, std::int64_t most, Draw& draw) {
  Whole p = any_whole(draw, most);
  if (in_plane) p[1] = 0;
  return p;
}

/// Its first and third axes are in the plane z = 0.
WholeFrame draw_frame_in_plane(bool is_round, Draw& draw) {
  const auto flat = [&] {
    Whole p = any_whole(draw, 4);
    p[2] = 0;
    return p;
  };
  WholeFrame frame{{{{}, {0, 0, 1}, {}}}};
  if (!is_round && draw.below(4) == 3) {
    return draw.until(
        [&] {
          frame.axes[0] = flat();
          frame.axes[2] = flat();
          return frame;
        },
        [](const WholeFrame& f) { return cross(f.axes[0], f.axes[2]) != Whole{}; });
  }
  constexpr std::array<Whole, 4> kTriples = {{{1, 0, 1}, {3, 4, 5}, {5, 12, 13}, {8, 15, 17}}};
  auto [x, y, length] = draw.coin() ? kTriples[0] : draw.pick(kTriples);
  if (draw.coin()) std::swap(x, y);
  if (draw.coin()) x = -x;
  if (draw.coin()) y = -y;
  const std::int64_t sign = draw.coin() ? 1 : -1;
  return {{{{x, y, 0}, {0, 0, length}, {-sign * y, sign * x, 0}}}, length};
}

WholeFrame draw_frame(bool is_round, Draw& draw) {
  if (!is_round && draw.below(4) == 3) {
    return draw.until(
        [&] {
          WholeFrame frame;
          for (Whole& axis : frame.axes) axis = any_whole(draw, 4);
          return frame;
        },
        [](const WholeFrame& f) { return dot(cross(f.axes[0], f.axes[1]), f.axes[2]) != 0; });
  }
  return draw_right_angles(draw);
}

/// A body at z ≤ 0, whose part at z = 0 is the feature; and the weights that make its point
/// (0,0,0).
struct FramedBody {
  std::vector<Whole> points;
  std::vector<Rational> weights;
};

/// In order of their points: 1 to 4.
enum class BodyKind : std::uint8_t { kPoint, kSegment, kTriangle, kTetrahedron, kHull, kBox };
constexpr size_t kMostPoints = 15;
constexpr std::array kBodyKinds = {BodyKind::kPoint,       BodyKind::kSegment, BodyKind::kTriangle,
                                   BodyKind::kTetrahedron, BodyKind::kHull,    BodyKind::kBox};

/// The part at z = 0: 1, 2 or 3 points around (0,0,0), and their weights.
void add_feature(Feature feature, bool in_plane, FramedBody& body, Draw& draw) {
  const auto flat = [&] {
    Whole p = draw_whole(in_plane, 8, draw);
    p[2] = 0;
    return p;
  };
  if (feature == Feature::kCorner) {
    body = {{Whole{}}, {1}};
    return;
  }
  const std::int64_t i = draw.integer(1, 3);
  if (feature == Feature::kEdge) {
    const Whole a = draw.until(flat, [](const Whole& p) { return p != Whole{}; });
    body = {{a, -i * a}, {Rational(i, i + 1), Rational(1, i + 1)}};
    return;
  }
  const std::int64_t j = draw.integer(1, 3);
  const auto [a, b] = draw.until(
      [&] {
        const Whole first = flat();
        return std::pair(first, flat());
      },
      [](const auto& p) { return cross(p.first, p.second)[2] != 0; });
  const Rational all(i + j + 1);
  body = {{a, b, -i * a + -j * b}, {Rational(i) / all, Rational(j) / all, 1 / all}};
}

/// With the axes of a box that its feature asks for: in the plane for it, out of it below.
FramedBody draw_box(Feature feature, bool in_plane, Draw& draw) {
  std::array<Whole, 3> axes{};
  if (in_plane && feature == Feature::kEdge) {
    axes = {{{1, 0, 0}, {0, 0, 1}}};
  } else if (in_plane) {
    axes = draw.coin() ? std::array<Whole, 3>{{{3, 0, 4}, {-4, 0, 3}}}
                       : std::array<Whole, 3>{{{5, 0, 12}, {-12, 0, 5}}};
  } else if (feature == Feature::kFace) {
    axes = kRightAngles[draw.below(2)].axes;
  } else if (feature == Feature::kEdge) {
    axes = {{{5, 0, 0}, {0, 4, 3}, {0, -3, 4}}};
  } else {
    axes = kRightAngles[2 + draw.below(3)].axes;
  }
  FramedBody body{{Whole{}}, {1}};
  for (const Whole& axis : axes) {
    if (axis == Whole{}) continue;  // a box in a plane has two
    const Whole along = axis[2] > 0 ? -1 * axis : axis;
    const long before = axis[2] == 0 ? draw.integer(1, 4) : 0;
    const long after = draw.integer(1, 4);
    const size_t count = body.points.size();
    for (size_t i = 0; i < count; ++i) {
      const Whole p = body.points[i];
      const Rational weight = body.weights[i];
      body.points[i] = p + -before * along;
      body.weights[i] = weight * after / (before + after);
      body.points.push_back(p + after * along);
      body.weights.push_back(weight * before / (before + after));
    }
  }
  return body;
}

FramedBody draw_body(Feature feature, bool in_plane, Draw& draw) {
  const auto least = static_cast<std::uint8_t>(feature == Feature::kCorner ? BodyKind::kPoint
                                               : feature == Feature::kEdge ? BodyKind::kSegment
                                                                           : BodyKind::kTriangle);
  const BodyKind kind = kBodyKinds[least + draw.below(kBodyKinds.size() - least)];
  if (kind == BodyKind::kBox) return draw_box(feature, in_plane, draw);
  FramedBody body;
  add_feature(feature, in_plane, body, draw);
  const size_t count = kind == BodyKind::kHull ? static_cast<size_t>(draw.integer(5, kMostPoints))
                                               : static_cast<size_t>(kind) + 1;
  while (body.points.size() < count) {
    Whole p = draw_whole(in_plane, 8, draw);
    p[2] = -draw.integer(1, 8);
    body.points.push_back(p);
    body.weights.emplace_back(0);
  }
  return body;
}

/// No point twice, three points or more are not all in a line, and four or more not in a plane.
/// This last is not asked where everything is in one.
bool is_proper(const FramedBody& body, bool in_plane) {
  const std::vector<Whole>& p = body.points;
  if (std::set<Whole>(p.begin(), p.end()).size() < p.size()) return false;
  if (p.size() < 3) return true;
  const auto from_first = [&](size_t i) { return p[i] + -1 * p[0]; };
  bool is_flat = true;
  Whole normal{};
  for (size_t i = 2; i < p.size() && normal == Whole{}; ++i) {
    normal = cross(from_first(1), from_first(i));
  }
  for (size_t i = 0; i < p.size(); ++i) is_flat = is_flat && dot(normal, from_first(i)) == 0;
  return normal != Whole{} && is_flat == (in_plane || p.size() == 3);
}

/// The numbers of a scene, in units of the frame, of which kParts make a whole one.
constexpr std::int64_t kParts = 8;

/// Two bodies that touch in the plane of a frame.
struct FramedPair {
  std::array<FramedBody, 2> bodies;
  WholeFrame frame;
  std::int64_t lift = 0;  ///< both radii together, in parts of the length of the frame's axes
  std::array<std::int64_t, 2> radius{};
};

FramedPair draw_framed_pair(const std::array<Feature, 2>& features, bool in_plane, Draw& draw) {
  FramedPair pair;
  for (size_t s = 0; s < 2; ++s) {
    pair.bodies[s] = draw.until([&] { return draw_body(features[s], in_plane, draw); },
                                [&](const FramedBody& b) { return is_proper(b, in_plane); });
  }
  const bool are_points = pair.bodies[0].points.size() + pair.bodies[1].points.size() == 2;
  const bool is_round = are_points || draw.coin();
  pair.frame = in_plane ? draw_frame_in_plane(is_round, draw) : draw_frame(is_round, draw);
  pair.lift = is_round ? draw.integer(1, 4) * kParts / 2 : 0;
  const std::int64_t radii = pair.lift * pair.frame.length;
  if (is_round) {
    pair.radius[0] = draw.pick(std::array<std::int64_t, 4>{0, radii, radii / 2, radii / 4});
  }
  pair.radius[1] = radii - pair.radius[0];
  return pair;
}

/// The class of a contact of bodies, by what of each lies on its support plane of this normal,
/// which is towards the second. It is a point, several in a line, or others.
ContactClass class_of_bodies(const Query& query, const Vec3<Rational>& normal) {
  std::array<Feature, 2> features{};
  for (size_t s = 0; s < 2; ++s) {
    const Points<double>& points = query.patches[s].positions;
    const Vec3<Rational> none(0, 0, 0), up = s == 0 ? normal : Vec3<Rational>(-normal);
    std::vector<Rational> heights;
    for (const Vec3<double>& p : points) heights.push_back(dot(up, exact(p)));
    const auto first = static_cast<size_t>(std::ranges::max_element(heights) - heights.begin());
    Vec3<Rational> along = none;
    int dimension = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec3<Rational> way = exact(points[i]) - exact(points[first]);
      if (heights[i] != heights[first] || way == none) continue;
      if (along == none) along = way;
      dimension = std::max(dimension, cross(along, way) == none ? 1 : 2);
    }
    features[s] = dimension == 0   ? Feature::kCorner
                  : dimension == 1 ? Feature::kEdge
                                   : Feature::kFace;
  }
  return class_between(features[0], features[1]);
}

}  // namespace

bool has_bodies(const BodyKinds& kinds, ContactClass contact) {
  const auto count = [](Feature feature) {
    return feature == Feature::kCorner ? 1U : feature == Feature::kEdge ? 2U : 3U;
  };
  // In one of the two bodies at least, a point without a radius is no body.
  std::array<bool, 2> is_drawn{}, is_more{};
  for (size_t s = 0; s < 2; ++s) {
    for (size_t n = count(features_of(contact)[s]); n <= kMostPoints; ++n) {
      for (const bool is_round : {false, true}) {
        if (!is_one_of(kinds, n, is_round)) continue;
        is_drawn[s] = true;
        is_more[s] = is_more[s] || n > 1 || is_round;
      }
    }
  }
  return is_drawn[0] && is_drawn[1] && (is_more[0] || is_more[1]);
}

Attempted framed_bodies(const GeneratorOptions& options, Draw& draw) {
  const std::array<Feature, 2> features = features_of(options.contact);
  const auto [bodies, frame, lift, radius] = draw.until(
      [&] { return draw_framed_pair(features, options.plane, draw); },
      [&](const FramedPair& pair) {
        return is_one_of(options.bodies, pair.bodies[0].points.size(), pair.radius[0] > 0) &&
               is_one_of(options.bodies, pair.bodies[1].points.size(), pair.radius[1] > 0);
      });

  const bool is_miss = options.kind == CaseKind::kNMN;
  const std::int64_t gap = is_miss ? draw.integer(1, kParts) : 0;
  // (Families of bodies that turn, and those that graze, are made of a later contact.)
  const bool is_plain = options.family == Family::kBodies;
  const bool begins = is_plain || (is_of_a_mesh(options.family) && !is_grazing(options.family));
  const bool may_touch = begins && options.at_start && options.kind == CaseKind::kRP;
  const bool overlaps = options.initial_overlap;
  const bool at_start = overlaps || (may_touch && draw.below(8) == 7);
  const std::int64_t eighths = overlaps ? -draw.integer(0, 8) : at_start ? 0 : draw.integer(1, 8);
  Whole approach = draw_whole(options.plane, 16, draw);
  approach[2] = is_miss || is_grazing(options.family) ? 0 : -draw.integer(1, 16);
  const Whole common = draw.coin() ? Whole{} : draw_whole(options.plane, 8, draw);
  const std::uint64_t mover = draw.below(2);
  const bool is_far = draw.below(8) == 7;
  Whole place = draw_whole(options.plane, 16, draw);
  if (options.plane) std::swap(place[1], place[2]);  // it is not along the frame's axes
  const int unit = draw.integer(-7, 0);
  const bool is_wide = is_plain && options.binary64;
  if (is_far) {
    // Up to 2^50 in eighths of units: doubles hold what is added, too.
    const int away = draw.integer(10, is_wide ? 40 : 16);
    place = (std::int64_t{1} << (away - unit - 5)) * place;
  }

  Case out;
  Query& query = out.query;
  Witness witness;
  for (size_t s = 0; s < 2; ++s) {
    const Whole velocity = frame(s != mover ? common
                                 : s == 1   ? common + approach
                                            : common + -1 * approach);
    MovingPatch<double>& hull = query.patches[s];
    for (Whole p : bodies[s].points) {
      if (s == 1) p[2] = -p[2];
      p = kParts * p;
      if (s == 1) p[2] += lift + gap;
      const Whole start = frame(p) + -eighths * velocity + kParts * place;
      hull.positions.push_back(times_power(start, unit - 3));
    }
    hull.velocities.push_back(times_power(velocity, unit));
    hull.shape = Shape::hull(static_cast<int>(hull.positions.size()));
    hull.radius = std::ldexp(static_cast<double>(radius[s]), unit - 3);
    witness.weights[s] = bodies[s].weights;
  }
  const Dyadic t(Integer(static_cast<long>(eighths)), -3);
  witness.t = t.rational();
  query.t_max = *t.to_double_exactly() * draw.integer(2, 4) / 2.0;
  if (options.kind == CaseKind::kRP && exact(query.t_max) == witness.t) query.t_max *= 2;
  if (at_start) query.t_max = 1;
  if (options.kind == CaseKind::kRN) query.t_max = *(t - eps_t(options)).to_double_exactly();
  if (!is_wide && !is_binary32(query)) return tl::unexpected(Discard::kRoundTrip);
  const bool is_still = is_grazing(options.family) && approach == Whole{};
  if (is_still) return tl::unexpected(Discard::kFirstContact);

  Whole normal = frame.normal();
  if (draw.coin()) {
    std::swap(query.patches[0], query.patches[1]);
    std::swap(witness.weights[0], witness.weights[1]);
    normal = -1 * normal;
  }
  const bool touches = options.kind == CaseKind::kRP;
  Truth& truth = out.truth;
  if (overlaps) {
    // They have gone on for so long, or go back.
    if (draw.coin()) {
      for (MovingPatch<double>& hull : query.patches) {
        hull.velocities[0] = Vec3<double>(0, 0, 0) - hull.velocities[0];
      }
    }
    truth = decide(query).truth;
    if (truth.contact_by() != Rational(0)) return tl::unexpected(Discard::kFirstContact);
    return out;
  }
  truth.collides = touches;
  if (touches) truth.witness = witness;
  if (at_start && is_plain) return out;  // where it is a mesh, its faces are made by the normal
  BodyClearance clear{touches ? witness.t : exact(query.t_max), {}, !touches};
  for (int k = 0; k < 3; ++k) {
    clear.normal[k] = static_cast<long>(normal[static_cast<size_t>(k)]);
  }
  truth.clear_until = clear.until;
  truth.clearance = clear;
  if (!touches) truth.proof = proof_word(*truth.clearance);
  return out;
}

/// Two bodies that touch without depth, by t* at the latest: they move along the plane that is
/// between them. So a vertex passes exactly through another, or along a face. A ball touches an
/// edge or a vertex for one instant, as it passes by. The oracle decides. RP: kept is what is apart
/// at 0 and touches. NMN: they are moved apart by a step (just_missing.hpp).
Attempted grazing_bodies_case(const GeneratorOptions& options, Draw& draw) {
  GeneratorOptions plain = options;
  plain.kind = CaseKind::kRP;
  CCDFUZZ_TRY(Case made, framed_bodies(plain, draw));
  if (options.kind == CaseKind::kNMN) return just_missing(std::move(made), draw);
  made.truth = decide(made.query).truth;
  const auto& first = made.truth.witness;
  if (!first || first->t == 0) return tl::unexpected(Discard::kFirstContact);
  return made;
}

std::optional<Case> case_of_bodies(const Query& query) {
  Case out;
  out.query = query;
  out.truth = decide(query).truth;
  if (!out.truth.collides) return std::nullopt;
  if (const auto* apart = clearance_of<BodyClearance>(out.truth)) {
    out.origin.contact = name_of(class_of_bodies(query, apart->normal));
  }
  if (const auto touched = touched_face(out)) {
    out.origin.contact = name_of(class_of_bodies(touched->query, touched->clearance.normal));
  }
  out.origin.kind = name_of(*out.truth.collides ? CaseKind::kRP : CaseKind::kRN);
  out.origin.generator = "mutant";
  return out;
}

}  // namespace ccdfuzz
