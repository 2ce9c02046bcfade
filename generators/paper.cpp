#include "generators/paper.hpp"

#include "generators/prescribe.hpp"

namespace ccdfuzz {

std::optional<Scene> paper_scene(ContactClass contact, bool grazing, Draw& draw) {
  const std::array<Feature, 2> features = features_of(contact);
  std::array<Barycentric, 2> x;
  for (size_t s = 0; s < 2; ++s) x[s] = prescribe_in_parent(features[s], draw);

  const std::array<Points<Dyadic>, 2> parents = static_contact(x, draw);
  const std::optional<Vec3<Dyadic>> normal = static_check(parents, x);
  if (!normal) return std::nullopt;

  Scene scene;
  scene.contact.t = Dyadic(1);
  scene.normal = *normal;
  std::optional<GrazingPlane> plane;
  if (grazing) {
    plane = grazing_plane(parents, x, *normal, draw);
    if (!plane) return std::nullopt;
    scene.normal = plane->normal;
  }
  std::array<Points<Dyadic>, 2> points;
  for (size_t s = 0; s < 2; ++s) {
    const LocalPatch part = choose_local_patch(x[s], draw);
    scene.contact.x[s] = part.x;
    points[s] = extract(parents[s], part);
  }
  scene.patches = plane ? set_grazing(points, scene.contact, *plane, draw)
                        : set_in_motion(points, scene.contact, scene.normal, contact, draw);
  return scene;
}

}  // namespace ccdfuzz
