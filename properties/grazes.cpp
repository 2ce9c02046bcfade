#include <algorithm>
#include <cmath>

#include "certify/oracle/oracle.hpp"
#include "generators/generate.hpp"
#include "properties/planted_bodies.hpp"
#include "properties/property.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// A near miss is proven. It is near: 2^-16 of the largest coordinate would bring the bodies into
/// contact.
void check_just_missing(Draw& d) {
  GeneratorOptions options;
  options.family = Family::kBodiesGrazing;
  options.kind = CaseKind::kNMN;
  options.contact = d.pick(kContactClasses);
  const Case known = generate(options, d).value;
  show(d, "planted", known);
  claim_planted_truth(known, options.kind, {.bodies = true});
  double largest = 0;
  for (const MovingPatch<double>& body : known.query.patches) {
    for (const Vec3<double>& p : body.positions) {
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
  }
  Query nearer = known.query;
  nearer.separation = std::ldexp(largest, -16);
  CLAIM(decide(nearer).truth.collides == true);
}

}  // namespace

std::vector<Property> grazes_claims() {
  return {
      {"bodies.just_miss",
       "Bodies that just miss are proven apart, by no more than 2^-16 of the largest coordinate",
       "generators/just_missing.hpp", check_just_missing},
  };
}

}  // namespace ccdfuzz
