#include "generators/planted.hpp"

#include "base/verify.hpp"
#include "bezier/blossom.hpp"
#include "bezier/exact_patch.hpp"
#include "certify/checker/check_witness.hpp"
#include "generators/contact.hpp"
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
  Contact q;
  q.t = Dyadic(draw.integer(1, 8), -3);
  const Vec3<Dyadic> point = draw.vector(kPlantedBits, kPlantedUnit);
  for (size_t s = 0; s < 2; ++s) {
    MovingPatch<Dyadic> patch{any_surface(draw), {}, {}};
    q.uv[s] = point_on(features[s], patch.shape, kParameterBits, draw);
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      patch.positions.push_back(draw.vector(kPlantedBits, kPlantedUnit));
      patch.velocities.push_back(draw.vector(kPlantedBits, kPlantedUnit));
    }
    // What stands in positions is where they are at t*.
    const Vec3<Dyadic> to_point = point - evaluate<Dyadic>(patch.shape, patch.positions, q.uv[s]);
    for (Vec3<Dyadic>& p : patch.positions) p += to_point;
    patch.positions = patch.at(-q.t);
    q.query.patches[s] = to_doubles(patch).value();
  }
  CCDFUZZ_VERIFY(check_witness(q.query, q.witness()));
  Case out = case_of(q);
  out.origin.generator = "planted";
  return out;
}

}  // namespace ccdfuzz
