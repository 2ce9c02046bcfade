#include "generators/shaped/families.hpp"

#include <algorithm>

#include "generators/bodies.hpp"

namespace ccdfuzz {

namespace {

using enum ContactClass;
constexpr FamilyRow::Classes kAll = kContactClasses;
constexpr std::array kAllButFF = {kEF, kEE, kVF, kVE, kVV};
constexpr std::array kOfAFace = {kFF, kEF, kVF}, kOfBoundaries = {kEE, kVE, kVV};
constexpr std::array kOfARound = {kFF, kVF}, kOfACorner = {kVE, kVV};

/// Those of RP, RN, NHP and NMN.
constexpr FamilyRow::ClassesOfKinds kPositives = {kAll}, kRegulars = {kAll, kAll},
                                    kOfRounds = {kOfARound, kOfARound},
                                    kOfEdges = {kOfBoundaries, kOfBoundaries},
                                    kOfLines = {kOfAFace, kOfAFace}, kOfPoints = {kAll, kAllButFF},
                                    kOfBodies = {kAll, kAll, {}, kAll},
                                    kOfGrazes = {kAll, {}, {}, kAll},
                                    kOfTurns = {kOfACorner, {}, {}, kOfACorner};

/// In the order of Family.
constexpr auto kRows = std::to_array<FamilyRow>({
    {Family::kRegular, "regular", "the contact that --contact names, and nothing else",
     FamilyRow::ClassesOfKinds{kAll, kAll, kAll, kAll}, regular_variant},
    // They touch at t* ≤ t_max and at no other time. Against absolute pull-apart.
    {Family::kFlatGrazing, "flat-grazing",
     "nearly flat, sliding along each other on a plane through the origin", kPositives,
     flat_grazing_variant},
    // Against pull-apart relative to the intercept.
    {Family::kCommonVelocity, "common-velocity",
     "both with the same velocity of 2^8 to 2^20 on top of their own", kRegulars,
     common_velocity_variant},
    // Most near where products of two underflow.
    {Family::kScaled, "scaled", "all numbers times 2^k, k from -1000 to 900", kRegulars,
     scaled_variant},
    {Family::kTwins, "twins", "two control points a few ulps apart hide under a third", kPositives},
    // t* is a dyadic rational.
    {Family::kInteriorTime, "interior-time", "t* < t_max", kRegulars, interior_time_variant},
    // They then cross, part or both.
    {Family::kAtStart, "at-start", "in touch at t = 0; witness only", kPositives, at_start_variant},
    {Family::kResting, "resting",
     "in touch from start to end, without relative velocity; witness only", kPositives,
     resting_variant},
    {Family::kSliding, "sliding",
     "slide onto each other at t* and stay in touch for a time; witness only", kPositives,
     sliding_variant},
    // These four touch in more than one point, all in the contact plane but for area, at t* = t_max
    // = 1. The contact that the scene names is one of them. Before t* the plane separates the
    // patches, but curved ones of area, and several of FF, whose heights the checker does not see
    // to be ≥ 0.
    {Family::kSharedEdge, "shared-edge", "touch along an edge of both, or a part of it; EE VE VV",
     kOfEdges, touching_along_edges, have_edges_alike},
    {Family::kRuled, "ruled", "touch along a line of parameters; FF EF VF", kOfLines,
     touching_along_a_line, have_a_line},
    {Family::kSeveral, "several", "touch in two points at once, or more; of FF witness only",
     kOfPoints, touching_at_points, have_two_points},
    {Family::kArea, "area",
     "touch over an area, one being a part of the other at t*; curved ones witness only", kRegulars,
     touching_over_an_area, are_equal_surfaces},
    {Family::kDegenerate, "degenerate", "collapsed edges, repeated control points, no area",
     kRegulars, degenerate_variant},
    {Family::kSliver, "sliver", "2^4 to 2^30 times as long as wide", kRegulars, sliver_variant},
    {Family::kHighCurvature, "high-curvature", "much taller than wide above the contact plane",
     kRegulars, high_curvature_variant},
    // Coordinates of sizes of their own, 2^-900 to 2^800.
    {Family::kMixedScales, "mixed-scales",
     "one much smaller than the other, coordinates of different sizes", kRegulars,
     mixed_scales_variant},
    // Some as fast.
    {Family::kFarAway, "far-away", "as far from the origin as the bits allow", kRegulars,
     far_away_variant},
    // Exactly, or but for a few ulps: the lines that they make on every axis cross in one point.
    {Family::kConcurrentLines, "concurrent-lines",
     "all control points pass through one point at one time, or nearly", kRegulars,
     concurrent_lines_variant},
    // Or a planted one (planted.hpp), in other coordinates (elsewhere.hpp). It says of the time
    // before what that one does.
    {Family::kAnywhere, "anywhere",
     "contacts of these families and others in any scale and place; some witness only", kPositives},
    {Family::kBodies, "bodies", "convex bodies, as engines cast them; all numbers are floats",
     kOfBodies, framed_bodies, own_shapes},
    {Family::kWeighted, "weighted", "rational patches, with weights of any kind; half witness only",
     kRegulars, weighted_case, have_weights},
    {Family::kRound, "round", "exact spheres, cylinders, cones and tori; FF VF", kOfRounds,
     round_case, own_shapes},
    {Family::kApart, "apart", "the same with a separation; FF VF", kOfRounds, round_case,
     own_shapes},
    {Family::kTrimmed, "trimmed",
     "with loops at the contact; RN: the whole patches alone touch, in a hole", kRegulars,
     trimmed_case, have_a_surface},
    {Family::kEnds, "ends", "two positions, whose differences are no doubles", kRegulars,
     ends_case},
    {Family::kSeparated, "separated", "regular contacts at a separation", kRegulars,
     separated_case},
    {Family::kTurning, "turning", "convex bodies of which one turns, or both", kRegulars,
     turning_case, own_shapes},
    {Family::kSpinning, "spinning", "the same by an angular velocity", kRegulars, spinning_case,
     own_shapes},
    {Family::kMesh, "mesh", "a convex body against 1 to 8 triangles", kOfBodies, mesh_case,
     own_shapes},
    {Family::kMeshOneSided, "mesh-one-sided", "the same with fronts alone", kOfBodies, mesh_case,
     own_shapes},
    {Family::kBodiesGrazing, "bodies-grazing", "convex bodies that touch without depth", kOfGrazes,
     grazing_bodies_case, own_shapes},
    {Family::kMeshGrazing, "mesh-grazing", "a body grazes a mesh, and hits it later", kPositives,
     mesh_case, own_shapes},
    // A face in the plane of the motion is none of the fronts.
    {Family::kMeshGrazingOneSided, "mesh-grazing-one-sided", "the same with fronts alone; not FF",
     FamilyRow::ClassesOfKinds{kAllButFF}, mesh_case, own_shapes},
    // A contact of others begins at no rational time.
    {Family::kTurningGrazing, "turning-grazing",
     "bodies-grazing that turn about the plane's normal; VE VV", kOfTurns, turning_case,
     own_shapes},
    {Family::kSpinningGrazing, "spinning-grazing", "the same by an angular velocity; VE VV",
     kOfTurns, turning_case, own_shapes},
});
static_assert(std::ranges::equal(kRows, kAllFamilies, {}, &FamilyRow::family),
              "each family has a row in kRows, in the order of Family");

}  // namespace

bool own_shapes(ContactClass, const ShapePair&) {
  return false;
}

const FamilyRow& row_of(Family family) {
  return kRows.at(static_cast<size_t>(family));
}

}  // namespace ccdfuzz
