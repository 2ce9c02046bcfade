#include "generators/first_contact.hpp"

#include "ccd/certified/tdibm_c.hpp"
#include "ccd/rational/proves_clear.hpp"
#include "certify/checker/check_plane.hpp"
#include "generators/tangent_cone.hpp"

namespace ccdfuzz {

namespace {

Vec3<Dyadic> contact_velocity(const Scene& scene, size_t s) {
  return point_at(scene.patches[s].velocities, scene.contact.x[s]);
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

/// With this normal, through the contact at t* and moving along with the patches.
MovingPlane moving_plane(const Scene& scene, const Vec3<Dyadic>& normal) {
  const Dyadic& t = scene.contact.t;
  const Vec3<Dyadic> contact = point_at(scene.patches[0].at(t), scene.contact.x[0]);
  return {t.rational(),
          {normal[0].rational(), normal[1].rational(), normal[2].rational()},
          dot(normal, contact).rational()};
}

/// The certified double method finds no contact in [0, until]. Its budget is small: a search that
/// takes long here takes too long in exact arithmetic.
bool certified_clear(const Query& query, double until) {
  Query horizon = query;
  horizon.t_max = until;
  thread_local TdibmC method;
  return method.answer(horizon, {.precision = 0x1p-24, .max_pops = 10'000}).verdict ==
         Verdict::kMiss;
}

}  // namespace

bool prove_first_contact(const Scene& scene, Case& made, const Dyadic& until, bool grazing,
                         std::uint64_t max_pops) {
  CCDFUZZ_VERIFY(until < scene.contact.t);
  made.truth.clear_until = until.rational();
  const auto by_plane = [&](const Vec3<Dyadic>& normal) {
    const MovingPlane plane = moving_plane(scene, normal);
    const bool is_proven = check_plane(made.query, plane).has_value();
    if (is_proven) made.truth.clearance = plane;
    return is_proven;
  };
  if (by_plane(scene.normal)) return true;
  if (!grazing) {
    // Without such a normal the patches are in each other just before t*.
    const std::optional<Vec3<Dyadic>> normal = approach_normal(scene);
    if (!normal) return false;
    if (by_plane(*normal)) return true;
  }
  return proven_by_search(made.query, until, max_pops);
}

bool proven_by_search(const Query& query, const Dyadic& until, std::uint64_t max_pops) {
  const std::optional<double> horizon = until.to_double_exactly();
  return horizon && certified_clear(query, *horizon) &&
         proves_clear(query, until.rational(), {.pops = max_pops});
}

}  // namespace ccdfuzz
