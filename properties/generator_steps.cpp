#include <fmt/format.h>

#include "bezier/blossom.hpp"
#include "case/case_json.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/differential.hpp"
#include "generators/draw_contact.hpp"
#include "generators/draw_patch.hpp"
#include "generators/extract.hpp"
#include "generators/finalize.hpp"
#include "generators/generate.hpp"
#include "generators/grazing.hpp"
#include "generators/motion.hpp"
#include "generators/moving_plane.hpp"
#include "generators/one_sided.hpp"
#include "generators/paper.hpp"
#include "generators/planted.hpp"
#include "generators/prescribe.hpp"
#include "generators/shaped/features.hpp"
#include "generators/shaped/point_contacts.hpp"
#include "generators/static_contact.hpp"
#include "numeric/products.hpp"
#include "properties/property.hpp"

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

  std::string text() const {
    return fmt::format("{} {} {}", name_of(contact), to_text(points[0]), to_text(points[1]));
  }
};

StaticContact draw_static_contact(Draw& choices) {
  StaticContact drawn;
  drawn.contact = choices.pick(kContactClasses);
  const auto features = features_of(drawn.contact);
  for (std::size_t s = 0; s < 2; ++s) drawn.x[s] = prescribe_in_parent(features[s], choices);
  drawn.points = static_contact(drawn.x, choices);
  return drawn;
}

/// Step II: the patches meet, exactly.
Check check_coincidence(Draw& choices) {
  const StaticContact drawn = draw_static_contact(choices);
  return point_at(drawn.points[0], drawn.x[0]) == point_at(drawn.points[1], drawn.x[1])
             ? Check::holds()
             : Check::fails(drawn.text());
}

/// Eq. 19: in FF both patches have the same tangent plane; in EF the edge of patch 1 lies in that
/// of patch 2.
Check check_tangency(Draw& choices) {
  const StaticContact drawn = draw_static_contact(choices);
  const auto features = features_of(drawn.contact);
  if (features[1] != Feature::kFace || features[0] == Feature::kCorner) {
    return Check::discarded("no constraint for this class");
  }
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
  for (const Vec3<Dyadic>& tangent : in_plane) {
    if (dot(tangent, normal).sign() != 0) return Check::fails(drawn.text());
  }
  return Check::holds();
}

/// Step III: the part has the contact point where it says, and is the parent there.
Check check_extraction(Draw& choices) {
  const StaticContact drawn = draw_static_contact(choices);
  const LocalPatch part = choose_local_patch(drawn.x[0], choices);
  const Points<Dyadic> points = extract(drawn.points[0], part);
  return point_at(points, part.x) == point_at(drawn.points[0], drawn.x[0]) &&
                 feature_at(part.x) == feature_at(drawn.x[0])
             ? Check::holds()
             : Check::fails(drawn.text());
}

/// Step IV: the patches are at their place at t*, and the contact points come from their sides of
/// the plane (FF, EF, EE, VF).
Check check_motion(Draw& choices) {
  const StaticContact drawn = draw_static_contact(choices);
  const PrescribedContact contact{Dyadic(Integer(static_cast<long>(choices.integer(1, 8))), -3),
                                  drawn.x};
  const auto tangents = tangents_at(drawn.points[1], drawn.x[1]);
  const Vec3<Dyadic> normal = cross(tangents[0], tangents[1]);
  const auto patches = set_in_motion(drawn.points, contact, normal, drawn.contact, choices);
  const bool free = drawn.contact == ContactClass::kVE || drawn.contact == ContactClass::kVV;
  for (std::size_t s = 0; s < 2; ++s) {
    if (!(patches[s].at(contact.t) == drawn.points[s]))
      return Check::fails("not in place: " + drawn.text());
    const int towards_other = dot(normal, point_at(patches[s].velocities, drawn.x[s])).sign();
    const bool zero = normal[0].sign() == 0 && normal[1].sign() == 0 && normal[2].sign() == 0;
    if (!free && !zero && towards_other * (s == 0 ? -1 : 1) < 0) {
      return Check::fails("it comes from the wrong side: " + drawn.text());
    }
  }
  return Check::holds();
}

/// The one-sided family: the moving plane proves that t* is the first contact.
Check check_one_sided(Draw& choices) {
  const ContactClass contact = choices.pick(kContactClasses);
  const Scene scene = one_sided_scene(contact, {}, choices);
  const auto point = [&](std::size_t s) {
    return point_at(scene.patches[s].at(scene.contact.t), scene.contact.x[s]);
  };
  if (!(point(0) == point(1))) return Check::fails("the patches do not meet");
  return moving_plane_separates(scene, scene.normal)
             ? Check::holds()
             : Check::fails(fmt::format("{}: its plane proves nothing", name_of(contact)));
}

std::string text_of(const GeneratorOptions& options) {
  std::string shapes;
  if (options.shapes) {
    shapes = fmt::format(" {},{}", to_text((*options.shapes)[0]), to_text((*options.shapes)[1]));
  }
  return fmt::format("{} {} {}{} seed {}, proven in {} pops", name_of(options.contact),
                     name_of(options.kind), name_of(options.family), shapes, options.seed,
                     options.proof_pops);
}

/// Step IV of a near-hit: at t* the contact points meet, and slide along the contact plane; what
/// has no share in the contact comes from its patch's side. The near-miss of it is apart.
Check check_grazing(Draw& choices) {
  const ContactClass contact = choices.pick(kContactClasses);
  std::optional<Scene> scene = paper_scene(contact, true, choices);
  if (!scene) return Check::discarded("no plane is found");
  const auto fails = [&](const char* what) {
    return Check::fails(fmt::format("{}: {}", name_of(contact), what));
  };
  const PrescribedContact& at = scene->contact;
  const auto place = [&](std::size_t s) { return point_at(scene->patches[s].at(at.t), at.x[s]); };
  const auto above = [&](const Vec3<Dyadic>& a, const Vec3<Dyadic>& b) {
    return dot<Dyadic>(scene->normal, Vec3<Dyadic>(a - b)).sign();
  };
  if (!(place(0) == place(1))) return fails("they do not meet");
  std::array<Vec3<Dyadic>, 2> v;
  for (std::size_t s = 0; s < 2; ++s) v[s] = point_at(scene->patches[s].velocities, at.x[s]);
  if (v[0] == v[1] || above(v[0], v[1]) != 0) return fails("they do not slide");
  for (std::size_t s = 0; s < 2; ++s) {
    for (const Vec3<Dyadic>& rate : scene->patches[s].velocities) {
      if (above(rate, v[s]) * (s == 0 ? 1 : -1) > 0) return fails("a part comes from elsewhere");
    }
  }
  part(*scene, static_cast<int>(choices.integer(kLeastGap, kLargestGap)));
  return above(place(1), place(0)) < 0 ? Check::holds() : fails("its near-miss is none");
}

/// The same of any shapes, whose contact plane is z = 0.
Check check_grazing_shapes(Draw& choices) {
  GeneratorOptions options = draw_regular_options(choices);
  const bool near_miss = choices.coin();
  options.kind = near_miss ? CaseKind::kNMN : CaseKind::kNHP;
  if (!validate(options)) options.shapes.reset();
  if (!options.shapes) options.shapes = {Shape::triangle(2), Shape::triangle(2)};
  const ContactScene scene =
      grazing_variant(near_miss, options.contact, *options.shapes, choices).scene;
  for (std::size_t s = 0; s < 2; ++s) {
    const ContactSide& side = scene.sides[s];
    const int height = evaluate<Dyadic>(side.shape, side.points, side.at)[2].sign();
    if (height != (near_miss && s == 1 ? -1 : 0)) {
      return Check::fails(fmt::format("{}: patch {} is not in its place", text_of(options), s + 1));
    }
    for (const Vec3<Dyadic>& rate : side.rates) {
      if (rate[2].sign() != 0) {
        return Check::fails(fmt::format("{}: patch {} crosses", text_of(options), s + 1));
      }
    }
  }
  return Check::holds();
}

/// A generated case is what it says: its witness is one, at the features of its class; its numbers
/// are doubles; and the same options give it again.
Check check_generated(Draw& choices) {
  const GeneratorOptions options = draw_generator_options(choices);
  const Case made = generate(options, 0).value;
  const auto fails = [&](const std::string& what) {
    return Check::fails(fmt::format("{}: {}\n{}", text_of(options), what, to_json(made)));
  };
  if (const auto checked = check_truth(made); !checked) return fails(checked.error().message());
  if (!(generate(options, 0).value == made)) return fails("made again, it is another case");
  const bool positive = options.kind == CaseKind::kRP || options.kind == CaseKind::kNHP;
  if (made.truth.collides != positive) return fails("not of its kind");
  if (!positive || !made.truth.witness) return Check::holds();
  const auto features = features_of(options.contact);
  for (std::size_t s = 0; s < 2; ++s) {
    const Uv<Rational>& uv = made.truth.witness->uv[s];
    const auto u = Dyadic::from(uv[0]), v = Dyadic::from(uv[1]);
    if (!u || !v || feature_at(made.query.patches[s].shape, {*u, *v}) != features[s]) {
      return fails("the contact is at another feature");
    }
  }
  return Check::holds();
}

/// The oracle proves no contact in a generated negative, nor before clear_until in a positive.
Check check_generated_clearance(Draw& choices) {
  const GeneratorOptions options = draw_regular_options(choices);
  const Case made = generate(options, 0).value;
  if (!made.truth.clear_until) return Check::discarded("nothing is said of the time before");
  OracleOptions little;
  little.max_pops = 100;
  little.max_tree_nodes = 200;
  const Decision decision = decide(made.query, little);
  const auto contact = decision.truth.contact_by();
  if (!contact || (*made.truth.clear_until <= *contact && made.truth.collides == true)) {
    return Check::holds();
  }
  return Check::fails(
      fmt::format("{}: contact by {}\n{}", text_of(options), to_text(*contact), to_json(made)));
}

constexpr ContactRange kAnywhere{
    .lowest = -1000, .highest = 900, .max_degree = 5, .elsewhere = true};

/// Drawn and planted contacts are contacts.
Check check_other_contacts(Draw& choices) {
  Case made;
  if (choices.coin()) {
    const Result<Case> drawn = draw_contact(choices, kAnywhere);
    if (!drawn) return Check::discarded(drawn.error().message());
    made = *drawn;
  } else {
    const ContactClass contact = choices.pick(kContactClasses);
    made = planted_case(contact, choices);
  }
  const auto checked = check_truth(made);
  if (checked && made.truth.witness) return Check::holds();
  return Check::fails((checked ? "no witness" : checked.error().message()) + "\n" + to_json(made));
}

}  // namespace

std::vector<Property> generator_steps_claims() {
  constexpr auto kHolds = Expectation::kHolds;
  return {
      {"generator.coincidence", "The patches of Step II meet at the prescribed parameters, exactly",
       "Section 5.1, Step II", kHolds, check_coincidence},
      {"generator.tangency", "Face contacts are tangential where the paper constrains them",
       "Eq. 19, Section 5.3", kHolds, check_tangency},
      {"generator.extraction", "A local part holds the contact point at the same feature",
       "Section 5.1, Step III, Appendix E.4", kHolds, check_extraction},
      {"generator.motion", "Patches in motion are in place at t*, each coming from its side",
       "Section 5.1, Step IV, Section 5.2", kHolds, check_motion},
      {"generator.first_contact", "The moving plane of a one-sided scene proves its first contact",
       "generators/one_sided.hpp", kHolds, check_one_sided},
      {"generator.grazing",
       "Grazing patches meet at t*, slide along the contact plane, and are apart in a near-miss",
       "Section 5.2", kHolds, check_grazing},
      {"generator.grazing_shapes", "The same of patches of any shapes",
       "generators/shaped/point_contacts.hpp", kHolds, check_grazing_shapes},
      {"generator.cases", "A generated case has the truth, the class and the numbers that it says",
       "Section 5.1, Step VI, Section 5.4", kHolds, check_generated},
      {"generator.clearance", "Nothing proves a contact where a case claims that there is none",
       "Section 5.1, Step V", kHolds, check_generated_clearance},
      {"generator.other_contacts", "Drawn and planted contacts are contacts",
       "generators/draw_contact.hpp, generators/planted.hpp", kHolds, check_other_contacts},
  };
}

}  // namespace ccdfuzz
