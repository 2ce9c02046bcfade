#include "generators/planted.hpp"

#include "base/verify.hpp"
#include "bezier/blossom.hpp"
#include "certify/checker/check_witness.hpp"
#include "generators/finalize.hpp"
#include "generators/shaped/features.hpp"

namespace ccdfuzz {

namespace {

// Parameters are multiples of 1/4. So the weights of a patch whose degrees add up to n ≤ 6 are
// multiples of 4^-n. Its coordinates are multiples of 1/16, and its point is a multiple of
// 2^(-2n-4), as is the way to the other's. The way to t* is a multiple of 2^-7.
constexpr int kPlantedBits = 8, kParameterBits = 2;
constexpr long kPlantedUnit = -4;

Shape any_surface(Draw& draw) {
  if (draw.coin()) return Shape::triangle(2);
  if (draw.coin()) return Shape::triangle(draw.integer(1, 4));
  const int n = draw.integer(1, 3);
  return Shape::tensor(n, draw.integer(1, 3));
}

}  // namespace

Case planted_case(ContactClass contact, Draw& draw) {
  const std::array<Feature, 2> features = features_of(contact);
  Scene scene;
  scene.contact.t = Dyadic(draw.integer(1, 8), -3);
  scene.t_max = 1;
  Witness witness;
  witness.t = scene.contact.t.rational();
  const Vec3<Dyadic> point = draw.vector(kPlantedBits, kPlantedUnit);
  for (size_t s = 0; s < 2; ++s) {
    const Shape shape = any_surface(draw);
    const Uv<Dyadic> uv = point_on(features[s], shape, kParameterBits, draw);
    witness.uv[s] = {uv[0].rational(), uv[1].rational()};
    MovingPatch<Dyadic>& patch = scene.patches[s];
    patch.shape = shape;
    for (int i = 0; i < shape.control_count(); ++i) {
      patch.positions.push_back(draw.vector(kPlantedBits, kPlantedUnit));
      patch.velocities.push_back(draw.vector(kPlantedBits, kPlantedUnit));
    }
    // What stands in positions is where they are at t*.
    const Vec3<Dyadic> to_point = point - evaluate<Dyadic>(shape, patch.positions, uv);
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      patch.positions[i] += to_point - patch.velocities[i] * scene.contact.t;
    }
  }
  const std::optional<Query> query = to_query(scene);
  CCDFUZZ_VERIFY(query && check_witness(*query, witness));
  Case out;
  out.query = *query;
  out.truth.collides = true;
  out.truth.witness = witness;
  out.origin.contact = name_of(contact);
  out.origin.kind = name_of(CaseKind::kRP);
  out.origin.generator = "planted";
  return out;
}

}  // namespace ccdfuzz
