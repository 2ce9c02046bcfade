#include "case/engine_test.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

namespace {

constexpr std::array kAxes = {0, 1, 2};

/// A body as the adapters give it to engines (examples/engines/bodies.mjs): its points about a
/// centre, which is the middle of its box where that and the differences are floats, and else 0.
struct EngineBody {
  Points<double> points;
  Vec3<double> centre{0, 0, 0};
  double radius = 0;
  std::optional<Vec3<double>> half;  ///< half the extents, where it is a box along the axes
};

bool is_float(double x) {
  return static_cast<double>(static_cast<float>(x)) == x;
}

EngineBody engine_body(const MovingPatch<double>& patch) {
  EngineBody body{patch.positions, {0, 0, 0}, patch.radius, {}};
  Vec3<double> low = patch.positions[0], high = low;
  for (const Vec3<double>& p : patch.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3<double> middle = (low + high) / 2;
  Points<double> about;
  bool is_exact = true;
  for (const Vec3<double>& p : patch.positions) {
    about.push_back(p - middle);
    for (const int k : kAxes) {
      is_exact = is_exact && is_float(middle[k]) && is_float(about.back()[k]) &&
                 exact(about.back()[k]) + exact(middle[k]) == exact(p[k]);
    }
  }
  if (!is_exact) return body;
  body.centre = middle;
  body.points = about;
  const Vec3<double> half = high - middle;
  const auto is_corner = [&](const Vec3<double>& p) { return p.cwiseAbs() == half; };
  std::vector<std::array<double, 3>> corners;
  for (const Vec3<double>& p : about) corners.push_back({p[0], p[1], p[2]});
  std::ranges::sort(corners);
  const bool are_different = std::ranges::adjacent_find(corners) == corners.end();
  if (about.size() == 8 && are_different && std::ranges::all_of(about, is_corner)) body.half = half;
  return body;
}

std::string list(const Vec3<double>& v) {
  return fmt::format("{}, {}, {}", v[0], v[1], v[2]);
}
std::string list(const Points<double>& points, std::string_view open, std::string_view close) {
  std::vector<std::string> texts;
  for (const Vec3<double>& p : points) texts.push_back(fmt::format("{}{}{}", open, list(p), close));
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// What an engine has for a body; empty where it has nothing.
std::string shape_text(Engine engine, const EngineBody& body) {
  const auto& [points, centre, radius, half] = body;
  const bool is_round = radius > 0;
  const bool is_ball = points.size() == 1 && is_round;
  const bool is_hull = points.size() >= 4 && !is_round;
  switch (engine) {
    case Engine::kRapier: {
      const std::string border = is_round ? fmt::format(", {}", radius) : "";
      const char* const round = is_round ? "Round" : "";
      if (is_ball) return fmt::format("new RAPIER.Ball({})", radius);
      if (points.size() == 2 && !is_round) {
        return fmt::format("new RAPIER.Segment({})", list(points, "vector(", ")"));
      }
      if (points.size() == 3) {
        return fmt::format("new RAPIER.{}Triangle({}{})", round, list(points, "vector(", ")"),
                           border);
      }
      if (half) return fmt::format("new RAPIER.{}Cuboid({}{})", round, list(*half), border);
      if (points.size() < 4) return "";
      return fmt::format("new RAPIER.{}ConvexPolyhedron(new Float32Array([{}]), null{})", round,
                         list(points, "", ""), border);
    }
    case Engine::kJolt:
      if (is_ball) return fmt::format("new Jolt.SphereShape({})", radius);
      if (half && !is_round) return fmt::format("new Jolt.BoxShape(vector({}), 0)", list(*half));
      return is_hull ? fmt::format("hull([{}])", list(points, "[", "]")) : "";
    case Engine::kPhysx:
      if (is_ball) return fmt::format("new physx.PxSphereGeometry({})", radius);
      if (half && !is_round) return fmt::format("new physx.PxBoxGeometry({})", list(*half));
      return is_hull ? fmt::format("hull([{}])", list(points, "[", "]")) : "";
    case Engine::kHavok:
      if (is_ball) return fmt::format("hk.HP_Shape_CreateSphere([0, 0, 0], {})[1]", radius);
      if (points.size() == 2 && is_round) {
        return fmt::format("hk.HP_Shape_CreateCapsule({}, {})[1]", list(points, "[", "]"), radius);
      }
      if (half && !is_round) {
        return fmt::format("hk.HP_Shape_CreateBox([0, 0, 0], [0, 0, 0, 1], [{}])[1]",
                           list(Vec3<double>(2 * *half)));
      }
      return is_hull ? fmt::format("hull([{}])", list(points, "[", "]")) : "";
    case Engine::kBullet:
      return fmt::format("hull({{{}}}, {})", list(points, "btVector3(", ")"), radius);
    case Engine::kFcl:
      return "";
  }
  return "";
}

/// {0} and {1}: the bodies; {2} and {3}: their centres; {4}: the motion of a against b.
constexpr const char* kRapier = R"(import RAPIER from '@dimforge/rapier3d-compat';
await RAPIER.init();
const vector = (x, y, z) => ({{ x, y, z }}), noTurn = {{ x: 0, y: 0, z: 0, w: 1 }};
const a = {0};
const b = {1};
const share = a.castShape(vector({2}), noTurn, vector({4}), b, vector({3}), noTurn,
                          vector(0, 0, 0), 0, 1, true)?.time_of_impact;
)";

constexpr const char* kJolt = R"(import initJolt from 'jolt-physics/wasm-compat';
const Jolt = await initJolt();
const world = new Jolt.JoltSettings();
world.mObjectLayerPairFilter = new Jolt.ObjectLayerPairFilterTable(1);
world.mBroadPhaseLayerInterface = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
world.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(
  world.mBroadPhaseLayerInterface, 1, world.mObjectLayerPairFilter, 1);
new Jolt.JoltInterface(world);
const vector = (x, y, z) => new Jolt.Vec3(x, y, z);
const hull = (points) => {{
  const settings = new Jolt.ConvexHullShapeSettings();
  settings.mMaxConvexRadius = settings.mHullTolerance = 0;
  for (const p of points) settings.mPoints.push_back(vector(...p));
  return settings.Create().Get();
}};
const a = {0};
const b = {1};
const middle = (shape, x, y, z) => {{
  const c = shape.GetCenterOfMass();
  return new Jolt.RVec3(x + c.GetX(), y + c.GetY(), z + c.GetZ());
}};
const target = new Jolt.TransformedShape();
target.mShape = b;
target.mShapePositionCOM = middle(b, {3});
target.mShapeRotation = Jolt.Quat.prototype.sIdentity();
const settings = new Jolt.ShapeCastSettings();
settings.mBackFaceModeConvex = Jolt.EBackFaceMode_CollideWithBackFaces;
const closest = new Jolt.CastShapeClosestHitCollisionCollector();
const start = Jolt.RMat44.prototype.sTranslation(middle(a, {2}));
target.CastShape(new Jolt.RShapeCast(a, vector(1, 1, 1), start, vector({4})), settings,
                 new Jolt.RVec3(0, 0, 0), closest, new Jolt.ShapeFilter());
const share = closest.HadHit() ? closest.mHit.mFraction : undefined;
)";

constexpr const char* kPhysx = R"(import {{ readFileSync }} from 'node:fs';
const wasm = new URL('physx-js-webidl.wasm', import.meta.resolve('physx-js-webidl'));
const node = globalThis.process;
delete globalThis.process;  // the package is for browsers and refuses to run where it sees Node
globalThis.window = {{}};
const physx = await (await import('physx-js-webidl')).default({{ wasmBinary: readFileSync(wasm) }});
globalThis.process = node;
const top = physx.PxTopLevelFunctions.prototype;
top.CreateFoundation(physx.PHYSICS_VERSION, new physx.PxDefaultAllocator(), new physx.PxDefaultErrorCallback());
const vector = (x, y, z) => new physx.PxVec3(x, y, z);
const hull = (points) => {{
  const corners = new physx.PxArray_PxVec3(0), description = new physx.PxConvexMeshDesc();
  for (const p of points) corners.pushBack(vector(...p));
  description.flags = new physx.PxConvexFlags(physx._emscripten_enum_PxConvexFlagEnum_eCOMPUTE_CONVEX());
  Object.assign(description.points, {{ count: points.length, stride: 12, data: corners.begin() }});
  const cooking = new physx.PxCookingParams(new physx.PxTolerancesScale());
  cooking.planeTolerance = 0;
  return new physx.PxConvexMeshGeometry(top.CreateConvexMesh(cooking, description));
}};
const pose = (...at) => new physx.PxTransform(vector(...at), new physx.PxQuat(0, 0, 0, 1));
const a = {0};
const b = {1};
const way = [{4}], length = Math.fround(Math.hypot(...way)), hit = new physx.PxSweepHit();
const flags = new physx.PxHitFlags(physx._emscripten_enum_PxHitFlagEnum_eDEFAULT());
const touches = physx.PxGeometryQuery.prototype.sweep(vector(...way.map((x) => x / length)), length,
                                                      a, pose({2}), b, pose({3}), hit, flags);
const share = touches ? hit.distance / length : undefined;
)";

constexpr const char* kHavok = R"(import {{ readFileSync }} from 'node:fs';
import HavokPhysics from '@babylonjs/havok';
const wasm = new URL(import.meta.resolve('@babylonjs/havok/lib/esm/HavokPhysics.wasm'));
const hk = await HavokPhysics({{ wasmBinary: readFileSync(wasm) }});
const hull = (points) => {{
  const address = hk._malloc(points.length * 12);
  new Float32Array(hk.HEAPU8.buffer, address, points.length * 3).set(points.flat());
  return hk.HP_Shape_CreateConvexHull(address, points.length)[1];
}};
const a = {0};
const b = {1};
for (const shape of [a, b]) hk.HP_Shape_SetFilterInfo(shape, [~0, ~0]);
const world = hk.HP_World_Create()[1], body = hk.HP_Body_Create()[1];
hk.HP_Body_SetShape(body, b);
hk.HP_Body_SetMotionType(body, hk.MotionType.STATIC);
hk.HP_Body_SetPosition(body, [{3}]);
hk.HP_World_AddBody(world, body, false);
const collector = hk.HP_QueryCollector_Create(1)[1];
const start = [{2}], way = [{4}];
hk.HP_World_ShapeCastWithCollector(world, collector,
  [a, [0, 0, 0, 1], start, start.map((x, k) => x + way[k]), false, [0n]]);
const share = hk.HP_QueryCollector_GetNumHits(collector)[1] > 0
  ? hk.HP_QueryCollector_GetShapeCastResult(collector, 0)[1][0] : undefined;
)";

constexpr const char* kBullet = R"(#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

btConvexHullShape hull(std::initializer_list<btVector3> points, btScalar margin) {{
  btConvexHullShape shape;
  for (const btVector3& p : points) shape.addPoint(p, false);
  shape.recalcLocalAabb();
  shape.setMargin(margin);
  return shape;
}}

TEST(ContinuousConvexCollision, FoundByCcdfuzz) {{
  const btConvexHullShape a = {0};
  const btConvexHullShape b = {1};
  const auto at = [](btScalar x, btScalar y, btScalar z) {{
    return btTransform(btQuaternion::getIdentity(), btVector3(x, y, z));
  }};
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btConvexCast::CastResult result;
  const bool touches = btContinuousConvexCollision(&a, &b, &simplex, &depth)
                           .calcTimeOfImpact(at(0, 0, 0), at({4}), at(0, 0, 0), at(0, 0, 0), result);
  const double share = touches ? result.m_fraction : -1;
)";

constexpr const char* kFcl = R"(#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

TEST(Intersect, FoundByCcdfuzz) {{
  using V = fcl::Vector3d;
  double share = -1;
  V where;
  const bool touches = fcl::detail::Intersect<double>::{0}(
      {1},
      {2}, &share, &where);
)";

constexpr const char* kGoogleTest = "#include <gtest/gtest.h>\n\n";

/// What every test ends with; share is undefined, or below 0 in C++, where the engine sees nothing.
std::string node_checks(const std::optional<double>& latest) {
  const std::string begin = "import assert from 'node:assert';\n";
  if (!latest) return begin + "assert(share === undefined, `a contact at ${share} of the way`);\n";
  return begin + fmt::format(
                     "assert(share !== undefined, 'the contact is missed');\n"
                     "assert(share <= {0}, `${{share}} is after {0} of the way`);\n",
                     *latest);
}
std::string google_checks(const std::optional<double>& latest) {
  if (!latest) return "  EXPECT_FALSE(touches) << \"at \" << share << \" of the way\";\n}\n";
  return fmt::format("  ASSERT_TRUE(touches);\n  EXPECT_LE(share, {});\n}}\n", *latest);
}

/// What is proven, in a line that a person can check.
std::string proof_text(const Case& value) {
  const auto& witness = value.truth.witness;
  if (!witness) {
    const auto contact = value.truth.contact_by();
    return contact ? fmt::format("They touch by t = {:.17g} of t_max = {}.", contact->get_d(),
                                 value.query.t_max)
                   : fmt::format("Nothing touches in [0, {}].", value.query.t_max);
  }
  std::vector<std::string> points;
  for (const size_t side : {size_t{0}, size_t{1}}) {
    const MovingPatch<double>& patch = value.query.patches[side];
    if (patch.shape.kind != ShapeKind::kHull) continue;
    Vec3<Rational> sum{Rational(0), Rational(0), Rational(0)};
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      for (const int k : kAxes) {
        sum[k] += witness->weights[side][i] *
                  (exact(patch.positions[i][k]) + witness->t * exact(patch.velocity(i)[k]));
      }
    }
    points.push_back(
        fmt::format("({}, {}, {})", to_text(sum[0]), to_text(sum[1]), to_text(sum[2])));
  }
  const std::string at =
      fmt::format("At t = {} of t_max = {}", to_text(witness->t), value.query.t_max);
  if (points.empty()) return at + " they have a point in common.";
  return fmt::format(
      "{} the cores have the points\n// {} and {},\n// no farther apart than the "
      "radii together.",
      at, points[0], points[1]);
}

Result<std::string> fcl_text(const NamedCase& named) {
  const Query query = with_velocities(named.value.query).value_or(named.value.query);
  const auto& [first, second] = query.patches;
  const bool is_face =
      first.shape.kind == ShapeKind::kPoint || second.shape.kind == ShapeKind::kPoint;
  const size_t count = first.positions.size() + second.positions.size();
  const bool is_linear =
      is_face
          ? count == 4 && (first.shape == Shape::triangle(1) || second.shape == Shape::triangle(1))
          : first.shape == Shape::curve(1) && second.shape == Shape::curve(1);
  if (!is_linear || has_ends(query) || query.separation > 0) {
    return input_error(named.id,
                       "fcl has tests of a vertex and a face, or of two edges, that touch");
  }
  std::array<std::vector<std::string>, 2> points;  // at 0 and at t_max
  const auto add = [&](const MovingPatch<double>& patch) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      points[0].push_back(fmt::format("V({})", list(patch.positions[i])));
      points[1].push_back(fmt::format(
          "V({})", list(Vec3<double>(patch.positions[i] + query.t_max * patch.velocities[i]))));
    }
  };
  // A vertex comes after the face.
  const bool is_swapped = is_face && first.shape.kind == ShapeKind::kPoint;
  add(is_swapped ? second : first);
  add(is_swapped ? first : second);
  return fmt::format(kFcl, is_face ? "intersect_VF" : "intersect_EE", fmt::join(points[0], ", "),
                     fmt::join(points[1], ", "));
}

Result<std::string> bodies_text(const NamedCase& named, Engine engine) {
  const Query& query = named.value.query;
  if (!is_of_bodies(query)) {
    return input_error(named.id, fmt::format("{} is asked about bodies", name_of(engine)));
  }
  const std::array bodies = {engine_body(query.patches[0]), engine_body(query.patches[1])};
  std::array<std::string, 2> shapes;
  for (size_t side = 0; side < 2; ++side) {
    EngineBody body = bodies[side];
    if (engine == Engine::kBullet) body.points = query.patches[side].positions;
    shapes[side] = shape_text(engine, body);
    if (shapes[side].empty() || query.separation > 0) {
      return input_error(fmt::format("{}: patches[{}]", named.id, side),
                         fmt::format("{} has no such shape", name_of(engine)));
    }
  }
  const Vec3<double> way =
      (query.patches[0].velocities[0] - query.patches[1].velocities[0]) * query.t_max;
  constexpr std::array kTexts = {kRapier, kJolt, kPhysx, kHavok, kFcl, kBullet};
  return fmt::format(fmt::runtime(kTexts[static_cast<size_t>(engine)]), shapes[0], shapes[1],
                     list(bodies[0].centre), list(bodies[1].centre), list(way));
}

}  // namespace

std::string_view name_of(Engine engine) {
  constexpr std::array<std::string_view, 6> kNames = {"rapier", "jolt", "physx",
                                                      "havok",  "fcl",  "bullet"};
  return kNames[static_cast<size_t>(engine)];
}

Result<std::string> engine_test(const NamedCase& named, Engine engine) {
  const Case& value = named.value;
  const auto contact = value.truth.contact_by();
  const Rational t_max = exact(value.query.t_max);
  const bool touches = contact && *contact <= t_max && t_max > 0;
  const bool is_clear = value.truth.clearance && covers(*value.truth.clearance, t_max);
  if (!touches && !is_clear) {
    return input_error(named.id, "neither a contact within t_max nor its absence is proven");
  }
  std::optional<double> latest;
  if (touches) latest = round_up(Rational(*contact / t_max));
  const bool is_cpp = engine == Engine::kFcl || engine == Engine::kBullet;
  const Result<std::string> asked =
      engine == Engine::kFcl ? fcl_text(named) : bodies_text(named, engine);
  return asked.map([&](const std::string& text) {
    const std::string head = fmt::format("// {}\n", proof_text(value));
    return is_cpp ? head + kGoogleTest + text + google_checks(latest)
                  : head + text + node_checks(latest);
  });
}

}  // namespace ccdfuzz
