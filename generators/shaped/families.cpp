#include "generators/shaped/families.hpp"

#include "generators/bodies.hpp"

namespace ccdfuzz {

namespace {

using enum ContactClass;
using Classes = std::span<const ContactClass>;

constexpr Classes kAll = kContactClasses;
constexpr Classes kNone;
constexpr std::array kOfBoundaries = {kEE, kVE, kVV};
constexpr std::array kOfARound = {kFF, kVF};
constexpr std::array kOfAFace = {kFF, kEF, kVF};
constexpr std::array kOfACorner = {kVE, kVV};
constexpr std::array kButFF = {kEF, kEE, kVF, kVE, kVV};

/// RP, RN, NHP, NMN.
constexpr decltype(FamilyRow::classes) of(Classes positives, Classes negatives = kNone,
                                          Classes near_hits = kNone, Classes near_misses = kNone) {
  return {positives, negatives, near_hits, near_misses};
}

constexpr std::array<FamilyRow, kAllFamilies.size()> kRows = {{
    {Family::kRegular, "regular", "the contact that --contact names, and nothing else",
     of(kAll, kAll, kAll, kAll), families::regular},
    // They touch at t* ≤ t_max and at no other time. Against absolute pull-apart.
    {Family::kFlatGrazing, "flat-grazing",
     "nearly flat, sliding along each other on a plane through the origin", of(kAll),
     families::flat_grazing},
    // Against pull-apart relative to the intercept.
    {Family::kCommonVelocity, "common-velocity",
     "both with the same velocity of 2^8 to 2^20 on top of their own", of(kAll, kAll),
     families::common_velocity},
    // Most near where products of two underflow.
    {Family::kScaled, "scaled", "all numbers times 2^k, k from -1000 to 900", of(kAll, kAll),
     families::scaled},
    {Family::kTwins, "twins", "two control points a few ulps apart hide under a third", of(kAll)},
    // t* is a dyadic rational.
    {Family::kInteriorTime, "interior-time", "t* < t_max", of(kAll, kAll), families::interior_time},
    // They then cross, part or both.
    {Family::kAtStart, "at-start", "in touch at t = 0; witness only", of(kAll), families::at_start},
    {Family::kResting, "resting",
     "in touch from start to end, without relative velocity; witness only", of(kAll),
     families::resting},
    {Family::kSliding, "sliding",
     "slide onto each other at t* and stay in touch for a time; witness only", of(kAll),
     families::sliding},
    {Family::kSharedEdge, "shared-edge", "touch along an edge of both, or a part of it; EE VE VV",
     of(kOfBoundaries, kOfBoundaries), families::shared_edge, families::have_edges_alike},
    {Family::kRuled, "ruled", "touch along a line of parameters; FF EF VF", of(kOfAFace, kOfAFace),
     families::ruled, families::have_a_line},
    {Family::kSeveral, "several", "touch in two points at once, or more; of FF witness only",
     of(kAll, kButFF), families::several, families::have_two_points},
    {Family::kArea, "area",
     "touch over an area, one being a part of the other at t*; curved ones witness only",
     of(kAll, kAll), families::area, families::are_equal_surfaces},
    {Family::kDegenerate, "degenerate", "collapsed edges, repeated control points, no area",
     of(kAll, kAll), families::degenerate},
    {Family::kSliver, "sliver", "2^4 to 2^30 times as long as wide", of(kAll, kAll),
     families::sliver},
    {Family::kHighCurvature, "high-curvature", "much taller than wide above the contact plane",
     of(kAll, kAll), families::high_curvature},
    // Coordinates of sizes of their own, 2^-900 to 2^800.
    {Family::kMixedScales, "mixed-scales",
     "one much smaller than the other, coordinates of different sizes", of(kAll, kAll),
     families::mixed_scales},
    // Some as fast.
    {Family::kFarAway, "far-away", "as far from the origin as the bits allow", of(kAll, kAll),
     families::far_away},
    // Exactly, or but for a few ulps: the lines that they make on every axis cross in one point.
    {Family::kConcurrentLines, "concurrent-lines",
     "all control points pass through one point at one time, or nearly", of(kAll, kAll),
     families::concurrent_lines},
    // Or a planted one (planted.hpp), in other coordinates (elsewhere.hpp). It says of the time
    // before what that one does.
    {Family::kAnywhere, "anywhere",
     "contacts of these families and others in any scale and place; some witness only", of(kAll)},
    {Family::kBodies, "bodies", "convex bodies, as engines cast them; all numbers are floats",
     of(kAll, kAll, kNone, kAll), nullptr, nullptr, framed_bodies},
    {Family::kWeighted, "weighted", "rational patches, with weights of any kind; half witness only",
     of(kAll, kAll), nullptr, families::have_weights, weighted_case},
    {Family::kRound, "round", "exact spheres, cylinders, cones and tori; FF VF",
     of(kOfARound, kOfARound), nullptr, nullptr, round_case},
    {Family::kApart, "apart", "the same with a separation; FF VF", of(kOfARound, kOfARound),
     nullptr, nullptr, round_case},
    {Family::kTrimmed, "trimmed",
     "with loops at the contact; RN: the whole patches alone touch, in a hole", of(kAll, kAll),
     nullptr, families::have_a_surface, trimmed_case},
    {Family::kEnds, "ends", "two positions, whose differences are no doubles", of(kAll, kAll),
     nullptr, nullptr, ends_case},
    {Family::kSeparated, "separated", "regular contacts at a separation", of(kAll, kAll), nullptr,
     nullptr, separated_case},
    {Family::kTurning, "turning", "convex bodies of which one turns, or both", of(kAll, kAll),
     nullptr, nullptr, turning_case},
    {Family::kSpinning, "spinning", "the same by an angular velocity", of(kAll, kAll), nullptr,
     nullptr, spinning_case},
    {Family::kMesh, "mesh", "a convex body against 1 to 8 triangles", of(kAll, kAll, kNone, kAll),
     nullptr, nullptr, mesh_case},
    {Family::kMeshOneSided, "mesh-one-sided", "the same with fronts alone",
     of(kAll, kAll, kNone, kAll), nullptr, nullptr, mesh_case},
    {Family::kBodiesGrazing, "bodies-grazing", "convex bodies that touch without depth",
     of(kAll, kNone, kNone, kAll), nullptr, nullptr, grazing_bodies_case},
    {Family::kMeshGrazing, "mesh-grazing", "a body grazes a mesh, and hits it later", of(kAll),
     nullptr, nullptr, mesh_case},
    // A face in the plane of the motion is none of the fronts.
    {Family::kMeshGrazingOneSided, "mesh-grazing-one-sided", "the same with fronts alone; not FF",
     of(kButFF), nullptr, nullptr, mesh_case},
    // A contact of others begins at no rational time.
    {Family::kTurningGrazing, "turning-grazing",
     "bodies-grazing that turn about the plane's normal; VE VV",
     of(kOfACorner, kNone, kNone, kOfACorner), nullptr, nullptr, turning_case},
    {Family::kSpinningGrazing, "spinning-grazing", "the same by an angular velocity; VE VV",
     of(kOfACorner, kNone, kNone, kOfACorner), nullptr, nullptr, turning_case},
}};

constexpr bool are_in_order() {
  for (size_t i = 0; i < kRows.size(); ++i) {
    if (kRows[i].family != kAllFamilies[i]) return false;
  }
  return true;
}
static_assert(are_in_order());

}  // namespace

bool families::have_weights(ContactClass, const ShapePair& shapes) {
  return shapes[0].kind != ShapeKind::kPoint || shapes[1].kind != ShapeKind::kPoint;
}

bool families::have_a_surface(ContactClass, const ShapePair& shapes) {
  return shapes[0].parameter_count() == 2 || shapes[1].parameter_count() == 2;
}

bool has_own_shapes(Family family) {
  return is_of_bodies(family) || family == Family::kRound || family == Family::kApart;
}

const FamilyRow& row_of(Family family) {
  return kRows.at(static_cast<size_t>(family));
}

}  // namespace ccdfuzz
