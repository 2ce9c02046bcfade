#include "bezier/blossom.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/differential.hpp"
#include "generators/draw_contact.hpp"
#include "generators/draw_patch.hpp"
#include "generators/extract.hpp"
#include "generators/generate.hpp"
#include "generators/grazing.hpp"
#include "generators/motion.hpp"
#include "generators/paper.hpp"
#include "generators/prescribe.hpp"
#include "generators/shaped/families.hpp"
#include "generators/shaped/features.hpp"
#include "generators/static_contact.hpp"
#include "numeric/products.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Vec3<Dyadic> point_at(const Points<Dyadic>& points, const Barycentric& x) {
  return weighted_sum(bernstein_weights(x), points);
}

/// Both tangents of a patch at a point.
std::array<Vec3<Dyadic>, 2> tangents_at(const Points<Dyadic>& points, const Barycentric& x) {
  return {slope(points, x, towards(corner_point(2), corner_point(0))),
          slope(points, x, towards(corner_point(2), corner_point(1)))};
}

/// Steps I and II of the paper's construction.
struct StaticContact {
  ContactClass contact = ContactClass::kFF;
  std::array<Barycentric, 2> x;
  std::array<Points<Dyadic>, 2> points;
};

StaticContact draw_static_contact(Draw& d) {
  StaticContact drawn;
  drawn.contact = d.pick(kContactClasses);
  const auto features = features_of(drawn.contact);
  for (std::size_t s = 0; s < 2; ++s) drawn.x[s] = prescribe_in_parent(features[s], d);
  drawn.points = static_contact(drawn.x, d);
  show(d, "class", drawn.contact);
  show(d, "points", drawn.points);
  return drawn;
}

/// Eq. 19: in FF both patches have the same tangent plane; in EF the edge of patch 1 lies in that
/// of patch 2.
void check_tangency(Draw& d) {
  const StaticContact drawn = draw_static_contact(d);
  const auto features = features_of(drawn.contact);
  suppose(features[1] == Feature::kFace && features[0] != Feature::kCorner);
  const auto face = tangents_at(drawn.points[1], drawn.x[1]);
  const Vec3<Dyadic> normal = cross(face[0], face[1]);
  std::vector<Vec3<Dyadic>> in_plane;
  if (features[0] == Feature::kFace) {
    const auto other = tangents_at(drawn.points[0], drawn.x[0]);
    in_plane = {other[0], other[1]};
  } else {
    const int corner = corner_opposite(drawn.x[0]);
    in_plane = {slope(drawn.points[0], drawn.x[0],
                      towards(corner_point((corner + 1) % 3), corner_point((corner + 2) % 3)))};
  }
  for (const Vec3<Dyadic>& tangent : in_plane) CLAIM(dot(tangent, normal).sign() == 0);
}

/// The contact points come from their sides of the plane in FF, EF, EE and VF.
void check_motion(Draw& d) {
  const StaticContact drawn = draw_static_contact(d);
  const PrescribedContact contact{Dyadic(d.integer(1, 8), -3), drawn.x};
  const auto tangents = tangents_at(drawn.points[1], drawn.x[1]);
  const Vec3<Dyadic> normal = cross(tangents[0], tangents[1]);
  const auto patches = set_in_motion(drawn.points, contact, normal, drawn.contact, d);
  const bool free = drawn.contact == ContactClass::kVE || drawn.contact == ContactClass::kVV;
  for (std::size_t s = 0; s < 2; ++s) {
    show(d, "patch", s + 1);
    CLAIM(patches[s].at(contact.t) == drawn.points[s]);
    const int towards_other = dot(normal, point_at(patches[s].velocities, drawn.x[s])).sign();
    const bool zero = normal[0].sign() == 0 && normal[1].sign() == 0 && normal[2].sign() == 0;
    CLAIM(free || zero || towards_other * (s == 0 ? -1 : 1) >= 0);
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
  CLAIM(!clearance || check_clearance(made.query, *clearance, "").has_value());
  if (!is_plain || !positive || !made.truth.witness) return;
  const auto features = features_of(options.contact);
  for (std::size_t s = 0; s < 2; ++s) {
    const Uv<Rational>& uv = made.truth.witness->uv[s];
    const auto u = Dyadic::from(uv[0]), v = Dyadic::from(uv[1]);
    CLAIM(u && v);
    CLAIM(feature_at(made.query.patches[s].shape, {*u, *v}) == features[s]);
  }
}

/// The oracle proves no contact in a generated negative, nor before clear_until in a positive.
void check_generated_clearance(Draw& d) {
  const GeneratorOptions options = draw_regular_options(d);
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
      {"generator.coincidence", "The patches of Step II meet at the prescribed parameters, exactly",
       "Section 5.1, Step II",
       [](Draw& d) {
         const auto [contact, x, points] = draw_static_contact(d);
         CLAIM(point_at(points[0], x[0]) == point_at(points[1], x[1]));
       }},
      {"generator.tangency", "Face contacts are tangential where the paper constrains them",
       "Eq. 19, Section 5.3", check_tangency},
      {"generator.extraction", "A local part holds the contact point at the same feature",
       "Section 5.1, Step III, Appendix E.4",
       [](Draw& d) {
         const StaticContact drawn = draw_static_contact(d);
         const LocalPatch part = choose_local_patch(drawn.x[0], d);
         const Points<Dyadic> points = extract(drawn.points[0], part);
         CLAIM(point_at(points, part.x) == point_at(drawn.points[0], drawn.x[0]));
         CLAIM(feature_at(part.x) == feature_at(drawn.x[0]));
       }},
      {"generator.motion", "Patches in motion are in place at t*, each coming from its side",
       "Section 5.1, Step IV, Section 5.2", check_motion},
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
