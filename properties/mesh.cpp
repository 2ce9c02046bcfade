#include "case/mesh.hpp"

#include <algorithm>

#include "certify/checker/check_bodies.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/draw_patch.hpp"
#include "generators/generate.hpp"
#include "method/setting.hpp"
#include "method/taken_query.hpp"
#include "properties/planted_bodies.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Case draw_mesh(Draw& d, CaseKind kind) {
  constexpr std::array kFamilies = {Family::kMesh, Family::kMeshOneSided, Family::kMeshGrazing};
  return draw_planted(d, kind, kFamilies[d.below(kind == CaseKind::kRP ? 3 : 2)]);
}

/// A mutant that is a mesh still, whose faces may have no area or be missed.
Query draw_any_mesh(Draw& d) {
  const Query first = draw_mesh(d, d.pick(kBodyCaseKinds)).query;
  Query query = draw_mutant(d, first, draw_mesh(d, CaseKind::kRP).query);
  suppose(has_mesh(query));
  return query;
}

/// A query without its mesh's windings: n and −n are of one plane.
void turn_all_round(Query& query) {
  for (Face& face : query.patches[mesh_side(query)].faces) std::swap(face[1], face[2]);
}

/// The planted truth holds, survives a file, and is not asked of who does not take it.
void check_mesh_truth(Draw& d) {
  const CaseKind kind = d.pick(kBodyCaseKinds);
  const Case known = draw_mesh(d, kind);
  CLAIM(has_mesh(known.query));
  claim_planted_truth(known, kind, {.meshes = true, .one_sided = true});
  const bool one_sided = known.query.patches[mesh_side(known.query)].one_sided;
  const auto is_taken_with = [&](bool of_its_sides, bool of_others) {
    Features features{.bodies = true};
    (one_sided ? features.one_sided : features.meshes) = of_its_sides;
    (one_sided ? features.meshes : features.one_sided) = of_others;
    return TakenQuery(known.query, features).query() != nullptr;
  };
  CLAIM(is_taken_with(true, false));
  CLAIM(!is_taken_with(false, true));
}

/// First of all faces that are there, by the truth of each as a hull. All are, of two sides.
void check_least_of_faces(Draw& d) {
  Query query = draw_any_mesh(d);
  MovingPatch<double>& mesh = query.patches[mesh_side(query)];
  if (d.coin()) mesh.one_sided = !mesh.one_sided;
  if (d.coin()) turn_all_round(query);
  const Truth truth = decide(query).truth;
  show(d, "found", Case{query, truth, {}, {}});
  CLAIM(check_case({query, truth, {}, {}}).has_value());
  const std::vector<size_t> there = faces_there(query);
  CLAIM(mesh.one_sided || there.size() == mesh.faces.size());
  std::optional<Rational> first;
  for (const size_t face : there) {
    const Truth part = decide(of_face(query, face)).truth;
    if (*part.collides && (!first || part.witness->t < *first)) first = part.witness->t;
  }
  CLAIM(truth.collides == first.has_value());
  if (first) CLAIM(truth.witness->t == *first);
}

/// The checker takes a point of a face for a witness if, and only if, the face is there.
void check_who_is_there(Draw& d) {
  Query query = draw_any_mesh(d);
  query.separation = 0x1p60;  // everything is near enough
  const size_t side = mesh_side(query);
  const MovingPatch<double>& mesh = query.patches[side];
  const size_t face = d.below(mesh.faces.size());
  Witness witness{0, {}};
  witness.weights[side].assign(mesh.positions.size(), 0);
  witness.weights[1 - side].assign(query.patches[1 - side].positions.size(), 0);
  witness.weights[1 - side][0] = 1;
  for (const int corner : mesh.faces[face]) {
    witness.weights[side][static_cast<size_t>(corner)] = Rational(1, 3);
  }
  const std::vector<size_t> there = faces_there(query);
  const auto is_same = [&](size_t other) {
    Face one = mesh.faces[face], two = mesh.faces[other];
    std::ranges::sort(one);
    std::ranges::sort(two);
    return one == two;
  };
  const bool is_there = std::ranges::any_of(there, is_same);
  CLAIM(check_body_contact(query, witness).has_value() == is_there);
  // A fourth point is of another face.
  suppose(mesh.positions.size() > 3);
  const size_t point = d.below(mesh.positions.size());
  suppose(witness.weights[side][point] == 0);
  for (Rational& w : witness.weights[side]) w /= 2;
  witness.weights[side][point] = Rational(1, 2);
  CLAIM(!check_body_contact(query, witness));
}

/// No directions of faces are a proof at their contact or past it, nor with one that is missing,
/// too many, or of another face.
void check_forged_faces(Draw& d) {
  const Case known = draw_mesh(d, CaseKind::kRP);
  const auto& clear = std::get<MeshClearance>(*known.truth.clearance);
  const auto is_refused = [&](const MeshClearance& forged) {
    return !check_clearance(known.query, forged);
  };
  CLAIM(!is_refused(clear));
  const size_t n = d.below(clear.normals.size());
  MeshClearance late = clear, closed = clear, more = clear, fewer = {0, clear.normals, true};
  more.normals.push_back(clear.normals[n]);
  fewer.normals.erase(fewer.normals.begin() + static_cast<long>(n));
  late.until += power_of_two(-d.integer(0, 100));
  closed.closed = true;
  CLAIM(is_refused(more));
  CLAIM(is_refused(fewer));
  suppose(clear.until == known.truth.witness->t);  // not where that is irrational
  CLAIM(is_refused(late));
  CLAIM(is_refused(closed));
}

/// A planted graze of a mesh whose last face is passed through later.
Case draw_graze(Draw& d, ContactClass contact, const BodyKind& kind) {
  const Family family = d.coin() ? Family::kMeshGrazing : Family::kMeshGrazingOneSided;
  const GeneratorOptions options = {.contact = contact, .family = family, .bodies = {kind}};
  suppose(validate(options).has_value());
  const Case known = show(d, "planted", generate(options, d).value);
  CLAIM(known.query.patches[mesh_side(known.query)].one_sided == is_one_sided(options.family));
  return known;
}

/// The graze is the first contact, and has no depth. The last face is passed through later.
void check_graze(Draw& d) {
  // Where a vertex grazes, what is about it may be deep. Bodies of few points are the quickest.
  const bool is_quick = d.below(4) > 0;
  const Case known = is_quick ? draw_graze(d, ContactClass::kVE, {2, 3, RadiusRule::kZero})
                              : draw_graze(d, d.pick(kContactClasses), {1, 4, RadiusRule::kAny});
  const Query& query = known.query;
  const size_t side = mesh_side(query);
  Query grazed = query;
  grazed.patches[side].faces.pop_back();
  Query wall = query;
  wall.patches[side].faces = {query.patches[side].faces.back()};
  CLAIM(check_case(known).has_value());
  const Truth first = decide(grazed).truth, later = decide(wall).truth;
  CLAIM(first.collides == true && later.collides == true);
  CLAIM(first.witness->t == known.truth.witness->t && first.witness->t > 0);
  CLAIM(later.witness->t >= first.witness->t);
  CLAIM(depth_until(grazed, query.t_max) == 0.0);
  const Vec3<double> way = query.patches[0].velocities[0] - query.patches[1].velocities[0];
  CLAIM(depth_until(wall, query.t_max) >= 0x1p-10 * query.t_max * way.norm());
}

/// It is no ordinary query if a face is touched at 0, there or not, or if there is no step.
void check_setting_of_one_sided(Draw& d) {
  Query query = draw_mesh(d, d.pick(kBodyCaseKinds)).query;
  MovingPatch<double>& mesh = query.patches[mesh_side(query)];
  mesh.one_sided = true;
  if (d.coin()) turn_all_round(query);
  const double later = query.t_max * static_cast<double>(d.below(5)) / 4;
  for (MovingPatch<double>& body : query.patches) {
    for (Vec3<double>& p : body.positions) p += later * body.velocities[0];
  }
  if (d.below(4) == 0) query.t_max = 0;
  show(d, "query", query);
  bool touches = false;
  for (size_t face = 0; face < mesh.faces.size(); ++face) {
    Query start = of_face(query, face);
    start.t_max = 0;
    touches = touches || *decide(start).truth.collides;
  }
  const Setting setting = setting_of({query, decide(query).truth, {}, {}});
  suppose(setting <= Setting::kTouching);
  CLAIM((setting == Setting::kTouching) == touches);
  CLAIM(setting != Setting::kOrdinary || query.t_max > 0);
}

}  // namespace

std::vector<Property> mesh_claims() {
  constexpr auto kMeshes = "src/case/mesh.hpp";
  constexpr auto kChecker = "src/certify/checker/check_bodies.hpp";
  constexpr auto kDeciding = "src/certify/oracle/decide_bodies.hpp";
  return {
      {"mesh.truth_holds",
       "The planted truth of a mesh is accepted and survives a file, and methods that do not take "
       "meshes say so",
       "generators/mesh.cpp", check_mesh_truth},
      {"mesh.is_least_of_faces",
       "Any mesh is decided, and touched when the first of its faces is that is there", kDeciding,
       check_least_of_faces},
      {"mesh.same_contact",
       "A mesh is touched at the same time if it is swapped, scaled, in another order, with a face "
       "twice or a point more",
       kMeshes,
       [](Draw& d) {
         const Query query = draw_any_mesh(d);
         claim_same_otherwise(d, query, decide(query).truth);
       }},
      {"mesh.graze_hides",
       "A body that grazes a mesh touches it first, without depth, also beside a vertex, and "
       "passes through it later",
       "generators/mesh.cpp", check_graze},
      {"mesh.setting_of_one_sided",
       "A one-sided mesh is touching at 0 if, and only if, a face is, from behind or in front",
       "src/method/setting.hpp", check_setting_of_one_sided},
      {"checker.knows_faces_there",
       "A point is a witness only of a face that is there, and of one face", kChecker,
       check_who_is_there},
      {"checker.refuses_forged_faces",
       "Directions of faces that are too many, too few or too late are refused", kChecker,
       check_forged_faces},
  };
}

}  // namespace ccdfuzz
