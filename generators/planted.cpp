#include "generators/planted.hpp"

#include "generators/prescribe.hpp"

namespace ccdfuzz {

Scene planted_scene(ContactClass contact, Random& random) {
  // Parameters are multiples of 1/4, so weights are multiples of 1/16, and coordinates multiples of
  // 1/16: the point of a patch is a multiple of 2^-8, and so is what moves it to the other's. The
  // way to t*, at a velocity that is a multiple of 1/16, is a multiple of 2^-7.
  constexpr int kBits = 8, kParameterBits = 2;
  constexpr long kUnit = -4;
  const std::array<Feature, 2> features = features_of(contact);
  Scene scene;
  scene.contact.t = Dyadic(Integer(static_cast<long>(random.between(1, 8))), -3);
  scene.t_max = 1;
  const Vec3<Dyadic> point = random.vector(kBits, kUnit);
  for (size_t s = 0; s < 2; ++s) {
    const Barycentric x = prescribe_anywhere(features[s], kParameterBits, random);
    scene.contact.x[s] = x;
    MovingPatch<Dyadic>& patch = scene.patches[s];
    patch = {kQuadratic, Points<Dyadic>(6), Points<Dyadic>(6)};
    for (size_t i = 0; i < 6; ++i) {
      patch.positions[i] = random.vector(kBits, kUnit);
      patch.velocities[i] = random.vector(kBits, kUnit);
    }
    const std::array<Dyadic, 6> weights = bernstein_weights(x);
    const Vec3<Dyadic> at = weighted_sum(weights, patch.positions);
    for (size_t i = 0; i < 6; ++i) {
      patch.positions[i] += point - at;
      patch.positions[i] -= patch.velocities[i] * scene.contact.t;
    }
  }
  return scene;
}

}  // namespace ccdfuzz
