#include "generators/twins.hpp"

#include "generators/differential.hpp"
#include "generators/exact_sum.hpp"
#include "generators/frame.hpp"
#include "generators/prescribe.hpp"
#include "generators/shaped/features.hpp"

namespace ccdfuzz {

namespace {

/// What a control point of patch 1 does on the normal.
enum class Role { kSlow, kTwin, kFast };

/// The unit in the last place of x as a double; 0 for 0.
Dyadic ulp(const Dyadic& x) {
  if (x.sign() == 0) return {};
  return {1, top_of(x) - 53};
}

/// The corner whose two mid controls are the twins. The contact's own controls are fast, but for a
/// contact inside the patch, where all are its own.
int twin_corner(const Barycentric& x, Draw& draw) {
  const Feature feature = feature_at(x);
  if (feature == Feature::kFace) return draw.integer(0, 2);
  return feature == Feature::kEdge ? corner_opposite(x) : corner_of(x);
}

Role role_of(int a, int b, int twin_corner, bool corner_is_fast) {
  if (a == twin_corner && b == twin_corner) return corner_is_fast ? Role::kFast : Role::kSlow;
  if (a == twin_corner || b == twin_corner) return Role::kTwin;
  return corner_is_fast ? Role::kSlow : Role::kFast;
}

// Heights at t* and speeds along m, in units of 2^-4. The lines, where s = t − t*:
//   slow   −1 + [0, .1]·s       twin   −[1, 1.25] + [.2, .5]·s       fast   [2, 4]·s
// The fast one overtakes the slow ones at s = −1/[1.9, 4] > −t*. The twins are below both then.
// Patch 2's line [8, 16]·s crosses the slow ones at s ≈ −1/8, and the fast one at s = 0.
constexpr long kStep = -10;
struct MotionRange {
  std::array<int, 2> height, speed;  ///< in multiples of 2^kStep
};
constexpr std::array<MotionRange, 3> kMotions = {
    {{{-64, -64}, {0, 6}}, {{-80, -64}, {13, 32}}, {{0, 0}, {128, 256}}}};

struct NormalMotion {
  Dyadic height, speed;
};

NormalMotion normal_motion(Role role, Draw& draw) {
  const auto& [height, speed] = kMotions[static_cast<size_t>(role)];
  NormalMotion motion;
  motion.height = Dyadic(draw.integer(height[0], height[1]), kStep);
  motion.speed = Dyadic(draw.integer(speed[0], speed[1]), kStep);
  return motion;
}

/// Moves twin a few ulps away from what it is a copy of. If it has a share in the contact, its
/// place at t* stays; else that may change too.
void nudge(Vec3<Dyadic>& position, Vec3<Dyadic>& velocity, const Dyadic& t, bool in_contact,
           Draw& draw) {
  for (int k = 0; k < 3; ++k) {
    const Dyadic coarser = std::max(ulp(position[k]), ulp(velocity[k]));
    if (in_contact) {
      // t is a multiple of 1/2 then, so both changes are whole ulps.
      const Dyadic change = coarser * Dyadic(2 * draw.integer(-1, 1));
      velocity[k] += change;
      position[k] -= change * t;
    } else {
      velocity[k] += ulp(velocity[k]) * Dyadic(draw.integer(-4, 4));
      position[k] += ulp(position[k]) * Dyadic(draw.integer(-4, 4));
    }
  }
}

MovingPatch<Dyadic> twin_patch(const PlaneFrame& frame, const Barycentric& x, const Dyadic& t,
                               Draw& draw) {
  const int corner = twin_corner(x, draw);
  const bool in_contact = feature_at(x) == Feature::kFace;
  const std::array<Planar, 6> tau = tangential_part(x, -14, draw);
  const Vec3<Dyadic> origin = draw.vector(12, -8);
  const NormalMotion slow = normal_motion(Role::kSlow, draw);
  const NormalMotion twin = normal_motion(Role::kTwin, draw);
  const NormalMotion fast = normal_motion(Role::kFast, draw);
  MovingPatch<Dyadic> patch{kQuadratic, Points<Dyadic>(6), Points<Dyadic>(6)};
  for (size_t i = 0; i < 6; ++i) {
    const auto [a, b] = kCornerPairs[i];
    const Role role = role_of(a, b, corner, feature_at(x) == Feature::kCorner);
    const NormalMotion& m = role == Role::kSlow ? slow : role == Role::kTwin ? twin : fast;
    patch.velocities[i] = frame.out * m.speed;
    patch.positions[i] = origin + point_of(frame, tau[i], m.height);
  }
  patch.positions = patch.at(-t);
  const size_t original = control_of(corner, (corner + 1) % 3);
  const size_t copy = control_of(corner, (corner + 2) % 3);
  if (!in_contact && draw.coin()) patch.positions[copy] = patch.positions[original];
  nudge(patch.positions[copy], patch.velocities[copy], t, in_contact, draw);
  return patch;
}

/// A small flat patch with one velocity, its point x at `contact` at time t.
MovingPatch<Dyadic> sweeping_patch(const PlaneFrame& frame, const Barycentric& x, const Dyadic& t,
                                   const Vec3<Dyadic>& contact, Draw& draw) {
  const std::array<Planar, 6> tau = tangential_part(x, -18, draw);
  const Dyadic speed(draw.integer(512, 1024), kStep);
  MovingPatch<Dyadic> patch{kQuadratic, {}, Points<Dyadic>(6, frame.out * speed)};
  for (const Planar& p : tau) patch.positions.push_back(contact + point_of(frame, p, Dyadic()));
  patch.positions = patch.at(-t);
  return patch;
}

}  // namespace

Scene twin_scene(ContactClass contact, Draw& draw) {
  const std::array<Feature, 2> features = features_of(contact);
  const PlaneFrame frame = random_frame(draw);
  Scene scene;
  scene.normal = frame.normal;
  // Late enough for all crossings above to come after 0.
  const bool halves_only = features[0] == Feature::kFace;
  scene.contact.t = halves_only ? Dyadic(1, -1) : Dyadic(draw.integer(5, 7), -3);
  for (size_t s = 0; s < 2; ++s) scene.contact.x[s] = prescribe_in_parent(features[s], draw);
  scene.patches[0] = twin_patch(frame, scene.contact.x[0], scene.contact.t, draw);
  const Vec3<Dyadic> point = point_at(scene.patches[0].at(scene.contact.t), scene.contact.x[0]);
  scene.patches[1] = sweeping_patch(frame, scene.contact.x[1], scene.contact.t, point, draw);
  return scene;
}

}  // namespace ccdfuzz
