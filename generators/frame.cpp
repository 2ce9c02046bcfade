#include "generators/frame.hpp"

#include "generators/draw_patch.hpp"
#include "generators/whole_frame.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// a·b' − a'·b
Dyadic area(const Planar& a, const Planar& b) {
  return a[0] * b[1] - a[1] * b[0];
}

Planar difference(const Planar& a, const Planar& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

/// With tangents that are drawn so.
template <class DrawTangent>
PlaneFrame frame_of(const DrawTangent& draw_tangent, Draw& draw) {
  PlaneFrame frame;
  const Vec3<Dyadic> zero = {Dyadic(), Dyadic(), Dyadic()};
  const auto normal = [](const auto& tangent) { return cross(tangent[0], tangent[1]); };
  frame.tangent = draw.until(
      [&] {
        std::array<Vec3<Dyadic>, 2> tangent;
        for (Vec3<Dyadic>& t : tangent) t = draw_tangent();
        return tangent;
      },
      [&](const auto& tangent) { return normal(tangent) != zero; });
  frame.normal = normal(frame.tangent);
  const auto side = [&](const Vec3<Dyadic>& out) { return dot(frame.normal, out).sign(); };
  frame.out = draw.until([&] { return exact_dyadic(draw_integers(draw, kFrameBound)); },
                         [&](const Vec3<Dyadic>& out) { return side(out) != 0; });
  if (side(frame.out) < 0) frame.out = -frame.out;
  return frame;
}

}  // namespace

PlaneFrame random_frame(Draw& draw) {
  return frame_of([&] { return exact_dyadic(draw_integers(draw, kFrameBound)); }, draw);
}

PlaneFrame whole_normal_frame(Draw& draw) {
  const WholeFrame right = draw_right_angles(draw);
  const auto draw_tangent = [&] {
    const std::int64_t first = draw.integer(-2, 2), second = draw.integer(-2, 2);
    return exact_dyadic(times_power(first * right.axes[0] + second * right.axes[1], 0));
  };
  return frame_of(draw_tangent, draw);
}

PlaneFrame draw_frame_near_axes(Draw& draw, std::int64_t most) {
  PlaneFrame frame;
  int k = 0;
  for (Vec3<Dyadic>* axis : {&frame.tangent[0], &frame.tangent[1], &frame.out}) {
    *axis = exact_dyadic(draw_integers(draw, most));
    (*axis)[k++] += Dyadic(1);
  }
  return frame;
}

std::array<Planar, 6> tangential_part(const Barycentric& x, long unit, Draw& draw) {
  const std::vector<Dyadic> weights = bernstein_weights(x);
  const auto corner = draw.until(
      [&] {
        std::array<Planar, 3> c;
        for (Planar& p : c) {
          for (Dyadic& along : p) along = draw.lattice(kTangentBits, unit);
        }
        return c;
      },
      [](const auto& c) {
        return area(difference(c[1], c[0]), difference(c[2], c[0])).sign() != 0;
      });
  std::array<Planar, 6> tau;
  Planar mean;
  for (size_t i = 0; i < 6; ++i) {
    const auto [a, b] = kCornerPairs[i];
    for (size_t k = 0; k < 2; ++k) {
      tau[i][k] = (corner[a][k] + corner[b][k]).scaled(-1);
      if (a != b) tau[i][k] += draw.lattice(kTangentBits - 3, unit);
      mean[k] += weights[i] * tau[i][k];
    }
  }
  for (Planar& p : tau) p = difference(p, mean);
  return tau;
}

}  // namespace ccdfuzz
