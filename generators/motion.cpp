#include "generators/paper.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

// Coordinates of x have 10 bits or fewer, so the weighted mean of a deformation is a multiple of
// 2^-35.
constexpr int kMaxStiffness = 5;

Points<Dyadic> deformation(const Barycentric& x, Draw& draw) {
  const int stiffness = draw.integer(0, kMaxStiffness);
  Points<Dyadic> rates;
  for (size_t i = 0; i < 6; ++i) rates.push_back(draw.vector(kSpeedBits - stiffness, kSpeedUnit));
  const Vec3<Dyadic> mean = point_at(rates, x);
  for (Vec3<Dyadic>& r : rates) r -= mean;
  return rates;
}

}  // namespace

std::array<MovingPatch<Dyadic>, 2> set_in_motion(const std::array<Points<Dyadic>, 2>& points,
                                                 const PrescribedContact& contact,
                                                 const Vec3<Dyadic>& normal, ContactClass kind,
                                                 Draw& draw) {
  const bool restricted = kind != ContactClass::kVE && kind != ContactClass::kVV;
  std::array<MovingPatch<Dyadic>, 2> patches;
  for (size_t s = 0; s < 2; ++s) {
    Vec3<Dyadic> speed = draw.vector(kSpeedBits, kSpeedUnit);
    const int wanted = s == 0 ? -1 : 1;
    if (restricted && dot(normal, speed).sign() * wanted < 0) speed = -speed;
    MovingPatch<Dyadic>& patch = patches[s];
    patch = {kQuadratic, points[s], deformation(contact.x[s], draw)};
    for (Vec3<Dyadic>& v : patch.velocities) v += speed;
    patch.positions = patch.at(-contact.t);
  }
  return patches;
}

}  // namespace ccdfuzz
