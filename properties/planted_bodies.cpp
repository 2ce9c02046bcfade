#include "properties/planted_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "case/mesh.hpp"
#include "case/scale.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/oracle.hpp"
#include "files/case_json.hpp"
#include "fuzz/mutator/mutate_query.hpp"
#include "generators/draw_patch.hpp"
#include "generators/similar.hpp"
#include "method/method.hpp"
#include "method/plugin/feature_claims.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

void reorder_mesh(MovingPatch<double>& mesh, const Vec3<double>& elsewhere, Draw& d) {
  for (Face& face : mesh.faces) {
    std::ranges::rotate(face, face.begin() + static_cast<long>(d.below(3)));
  }
  std::ranges::reverse(mesh.faces);
  const Face again = mesh.faces[d.below(mesh.faces.size())];
  if (mesh.faces.size() < kMaxFaces) mesh.faces.push_back(again);
  if (mesh.shape.n < kMaxControls) {
    mesh.positions.push_back(elsewhere);
    mesh.shape = Shape::hull(mesh.shape.n + 1);
  }
  if (d.coin()) drop_unused_points(mesh);
}

Query given_otherwise(Query query, Draw& d) {
  if (d.coin()) query = swapped(query);
  const int in_space = d.integer(-8, 8);
  for (MovingPatch<double>& body : query.patches) {
    const int length = d.integer(-8, 8);
    const double sign = d.coin() && body.turn && body.turn->is_quaternion() ? -1 : 1;
    if (body.turn && !body.turn->is_spin()) {
      for_each_turn_number(body, [&](double& x) { x = std::ldexp(sign * x, length); });
    }
    for_each_coordinate(body, [&](double& x) { x = std::ldexp(x, in_space); });
    std::ranges::reverse(body.positions);
    for (Face& face : body.faces) {
      for (int& corner : face) corner = body.shape.n - 1 - corner;
    }
  }
  query.separation = std::ldexp(query.separation, in_space);
  if (has_spins(query)) query = on_other_axes(std::move(query), d.integer(0, 2));
  if (!has_mesh(query)) return query;
  const std::size_t side = mesh_side(query);
  reorder_mesh(query.patches[side], query.patches[1 - side].positions[0], d);
  return query;
}

}  // namespace

Case draw_planted(Draw& d, CaseKind kind, Family family, bool in_plane) {
  GeneratorOptions options;
  options.kind = kind;
  options.family = family;
  options.plane = in_plane;
  options.binary64 = d.below(4) == 3;
  options.contact = d.until([&] { return d.pick(kContactClasses); },
                            [&](ContactClass contact) {
                              options.contact = contact;
                              return validate(options).has_value();
                            });
  const Case made = show(d, "planted", generate(options, d).value);
  CLAIM(options.binary64 || is_binary32(made.query));
  return made;
}

Query draw_mutant(Draw& d, const Query& first, const Query& other) {
  Query query = mutate_query(first, other, d);
  if (d.coin()) query.separation = std::ldexp(1.0, -d.integer(0, 20));
  show(d, "query", query);
  return query;
}

void claim_planted_truth(const Case& known, CaseKind kind, const Features& needs) {
  const auto checked = check_case(known);
  CLAIM(checked.has_value());
  CLAIM(checked->collides() == (kind == CaseKind::kRP));
  const auto read = parse_case(to_json(known, JsonLayout::kOneLine), "drawn");
  CLAIM(read && *read == known);
  for (const MethodInfo& info : registered_methods()) {
    CLAIM(check_taken(info.spec, known.query).has_value() == has_all(info.features, needs));
  }
}

void claim_same_time(const Truth& one, const Truth& other) {
  CLAIM(one.collides == other.collides);
  if (!*one.collides) return;
  CLAIM(one.witness->t >= other.clear_until.value_or(0));
  CLAIM(other.witness->t >= one.clear_until.value_or(0));
}

void claim_same_otherwise(Draw& d, const Query& query, const Truth& truth) {
  const Query same = show(d, "same", given_otherwise(query, d));
  const Truth other = decide(same).truth;
  if (has_turns(query)) suppose(truth.collides && other.collides);
  claim_same_time(truth, other);
}

}  // namespace ccdfuzz
