#include "generators/first_contact.hpp"

#include "generators/moving_plane.hpp"
#include "generators/prescribe.hpp"
#include "generators/tangent_cone.hpp"

namespace ccdfuzz {

namespace {

Vec3<Dyadic> contact_velocity(const Scene& scene, size_t s) {
  return weighted_sum(bernstein_weights(scene.contact.x[s]), scene.patches[s].velocities);
}

/// A normal N that separates the patches at t* to first order and along which they approach each
/// other. Where the contact has a tangent plane it is the only one, else one of many.
std::optional<Vec3<Dyadic>> approach_normal(const Scene& scene) {
  const Vec3<Dyadic> approach = contact_velocity(scene, 1) - contact_velocity(scene, 0);
  std::array<TangentCone, 2> cones;
  for (size_t s = 0; s < 2; ++s) {
    cones[s] = tangent_cone(scene.patches[s].at(scene.contact.t), scene.contact.x[s]);
  }
  return separating_normal(cones[0], cones[1], {approach});
}

}  // namespace

bool first_contact_is_proven(const Scene& scene, const Dyadic& until) {
  CCDFUZZ_VERIFY(until < scene.contact.t);
  if (moving_plane_separates(scene, scene.normal)) return true;
  // Without such a normal the patches are in each other just before t*.
  const std::optional<Vec3<Dyadic>> normal = approach_normal(scene);
  return normal && moving_plane_separates(scene, *normal);
}

}  // namespace ccdfuzz
