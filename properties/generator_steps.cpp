#include "bezier/blossom.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/differential.hpp"
#include "generators/draw_contact.hpp"
#include "generators/generate.hpp"
#include "generators/paper.hpp"
#include "generators/prescribe.hpp"
#include "generators/shaped/families.hpp"
#include "generators/shaped/features.hpp"
#include "numeric/products.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Both tangents of a patch at a point.
std::array<Vec3<Dyadic>, 2> tangents_at(const Points<Dyadic>& points, const Barycentric& x) {
  return {slope(points, x, towards(corner_point(2), corner_point(0))),
          slope(points, x, towards(corner_point(2), corner_point(1)))};
}

/// Steps I and II: the patches meet. Eq. 19: in FF both have the same tangent plane; in EF the edge
/// of patch 1 lies in that of patch 2. Step III: a local part has the point at the same feature.
/// Step IV: the contact points come from their sides of the plane in FF, EF, EE and VF.
void check_paper_steps(Draw& d) {
  const ContactClass contact = show(d, "class", d.pick(kContactClasses));
  const auto features = features_of(contact);
  PrescribedContact at;
  for (std::size_t s = 0; s < 2; ++s) at.x[s] = prescribe_in_parent(features[s], d);
  const auto points = show(d, "points", static_contact(at.x, d));
  CLAIM(point_at(points[0], at.x[0]) == point_at(points[1], at.x[1]));

  const auto face = tangents_at(points[1], at.x[1]), other = tangents_at(points[0], at.x[0]);
  const Vec3<Dyadic> normal = cross(face[0], face[1]);
  std::vector<Vec3<Dyadic>> in_plane;
  if (contact == ContactClass::kFF) in_plane = {other[0], other[1]};
  if (contact == ContactClass::kEF) {
    const int corner = corner_opposite(at.x[0]);
    in_plane = {slope(points[0], at.x[0],
                      towards(corner_point((corner + 1) % 3), corner_point((corner + 2) % 3)))};
  }
  for (const Vec3<Dyadic>& tangent : in_plane) CLAIM(dot(tangent, normal).sign() == 0);

  const LocalPatch part = choose_local_patch(at.x[0], d);
  CLAIM(point_at(extract(points[0], part), part.x) == point_at(points[0], at.x[0]));
  CLAIM(feature_at(part.x) == feature_at(at.x[0]));

  at.t = Dyadic(d.integer(1, 8), -3);
  const auto patches = set_in_motion(points, at, normal, contact, d);
  const bool free = contact == ContactClass::kVE || contact == ContactClass::kVV;
  for (std::size_t s = 0; s < 2; ++s) {
    show(d, "patch", s + 1);
    CLAIM(patches[s].at(at.t) == points[s]);
    const int towards_other = dot(normal, point_at(patches[s].velocities, at.x[s])).sign();
    CLAIM(free || normal == Vec3<Dyadic>() || towards_other * (s == 0 ? -1 : 1) >= 0);
  }
}

void show_options(Draw& d, const GeneratorOptions& options) {
  show(d, "class", options.contact);
  show(d, "kind", options.kind);
  show(d, "family", options.family);
  show(d, "shapes", options.shapes);
  show(d, "seed", options.seed);
  show(d, "proof_pops", options.proof_pops);
}

/// Also, what has no share in the contact comes from its patch's side.
void check_grazing(Draw& d) {
  const ContactClass contact = show(d, "class", d.pick(kContactClasses));
  Scene scene = supposed(paper_scene(contact, true, d));
  const PrescribedContact& at = scene.contact;
  const auto place = [&](std::size_t s) { return point_at(scene.patches[s].at(at.t), at.x[s]); };
  const auto above = [&](const Vec3<Dyadic>& a, const Vec3<Dyadic>& b) {
    return dot(scene.normal, Vec3<Dyadic>(a - b)).sign();
  };
  CLAIM(place(0) == place(1));
  std::array<Vec3<Dyadic>, 2> v;
  for (std::size_t s = 0; s < 2; ++s) v[s] = point_at(scene.patches[s].velocities, at.x[s]);
  CLAIM(!(v[0] == v[1]));
  CLAIM(above(v[0], v[1]) == 0);
  for (std::size_t s = 0; s < 2; ++s) {
    for (const Vec3<Dyadic>& rate : scene.patches[s].velocities) {
      CLAIM(above(rate, v[s]) * (s == 0 ? 1 : -1) <= 0);
    }
  }
  part(scene, d.integer(kLeastGap, kLargestGap));
  CLAIM(above(place(1), place(0)) < 0);
}

/// The same of any shapes, whose contact plane is z = 0.
void check_grazing_shapes(Draw& d) {
  GeneratorOptions options = draw_regular_options(d);
  const bool near_miss = d.coin();
  options.kind = near_miss ? CaseKind::kNMN : CaseKind::kNHP;
  if (!validate(options)) options.shapes.reset();
  if (!options.shapes) options.shapes = {Shape::triangle(2), Shape::triangle(2)};
  show_options(d, options);
  const ContactScene scene = grazing_variant(near_miss, options.contact, *options.shapes, d).scene;
  for (std::size_t s = 0; s < 2; ++s) {
    show(d, "patch", s + 1);
    const ContactSide& side = scene.sides[s];
    const int height = evaluate<Dyadic>(side.shape, side.points, side.at)[2].sign();
    CLAIM(height == (near_miss && s == 1 ? -1 : 0));
    for (const Vec3<Dyadic>& rate : side.rates) CLAIM(rate[2].sign() == 0);
  }
}

/// The contact is at the features of its class, and the same options give the case again.
void check_generated(Draw& d) {
  GeneratorOptions options = draw_generator_options(d);
  const bool is_plain = d.choose(3) != 3;
  if (!is_plain) {
    options.family = d.pick(kNotPlainFamilies);
    options.kind = d.coin() ? CaseKind::kRN : CaseKind::kRP;
    options.shapes.reset();
    options.proof_pops = 1000;
    suppose(is_made(options.family, options.contact, options.kind));
  }
  const Case made = is_plain ? generate(options, 0).value : generate(options, d).value;
  const Result<void> checked = show(d, "truth", check_truth(made));
  show_options(d, options);
  show(d, "case", made);
  CLAIM(checked.has_value());
  CLAIM(!is_plain || generate(options, 0).value == made);
  const bool positive = options.kind == CaseKind::kRP || options.kind == CaseKind::kNHP;
  CLAIM(made.truth.collides == positive);
  const auto& clearance = made.truth.clearance;
  CLAIM(!clearance || check_clearance(made.query, *clearance).has_value());
  if (!is_plain || !positive || !made.truth.witness) return;
  const auto features = features_of(options.contact);
  for (std::size_t s = 0; s < 2; ++s) {
    const Uv<Rational>& uv = made.truth.witness->uv[s];
    const auto u = Dyadic::from(uv[0]), v = Dyadic::from(uv[1]);
    CLAIM(u && v);
    CLAIM(feature_at(made.query.patches[s].shape, {*u, *v}) == features[s]);
  }
}

/// The oracle proves no contact in a generated negative, nor before clear_until in a positive, also
/// at a separation.
void check_generated_clearance(Draw& d) {
  GeneratorOptions options = draw_regular_options(d);
  if (d.coin()) {
    options.family = d.pick(std::array{Family::kApart, Family::kSeparated});
    options.shapes.reset();
    suppose(is_made(options.family, options.contact, options.kind));
  }
  const Case made = show(d, "case", generate(options, 0).value);
  suppose(made.truth.clear_until.has_value());
  const Decision decision = decide(made.query, {.max_pops = 100, .max_tree_nodes = 200});
  const auto contact = show(d, "contact by", decision.truth.contact_by());
  if (!contact) return;
  show_options(d, options);
  CLAIM(made.truth.collides == true);
  CLAIM(*made.truth.clear_until <= *contact);
}

}  // namespace

std::vector<Property> generator_steps_claims() {
  return {
      {"generator.paper_steps",
       "The patches of Step II meet, tangentially where the paper constrains them; a local part "
       "holds the point at the same feature; in motion they come from their sides, to their places",
       "Sections 5.1 to 5.3, Eq. 19, Appendix E.4", check_paper_steps},
      {"generator.grazing",
       "Grazing patches meet at t*, slide along the contact plane, and are apart in a near-miss",
       "Section 5.2", check_grazing},
      {"generator.grazing_shapes",
       "Grazing patches of any shapes meet at t*, slide along the contact plane, and are apart in "
       "a near-miss",
       "generators/shaped/families.hpp", check_grazing_shapes},
      {"generator.cases",
       "A generated case, also of weights, loops, ends and separations, is what it says",
       "Section 5.1, Step VI, Section 5.4", check_generated},
      {"generator.clearance", "Nothing proves a contact where a case claims that there is none",
       "Section 5.1, Step V", check_generated_clearance},
  };
}

}  // namespace ccdfuzz
