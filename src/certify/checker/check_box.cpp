#include "certify/checker/check_box.hpp"

#include <fmt/format.h>

#include "certify/checker/check_trim.hpp"
#include "certify/checker/taylor.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

tl::unexpected<InputError> refuse_box(std::string what) {
  return input_error("truth.certificate.contact", std::move(what));
}

/// True iff x ± radius, y ± radius lie in the shape's domain; 0 for parameters that it lacks.
bool in_domain(const Shape& shape, const std::array<Dyadic, 2>& x,
               const std::array<Dyadic, 2>& radius, int dependent) {
  const Dyadic one(1), zero(0);
  if (dependent != 0 && shape.kind != ShapeKind::kTriangle) return false;
  for (int k = 0; k < 2; ++k) {
    if (k < shape.parameter_count()) {
      if (x[k] - radius[k] < zero || x[k] + radius[k] > one) return false;
    } else if (x[k] != zero || radius[k] != zero) {
      return false;
    }
  }
  return shape.kind != ShapeKind::kTriangle || x[0] + radius[0] + x[1] + radius[1] <= one;
}

/// Whether the box is proven to be in the closed region of the loops. It is a point of the region,
/// or an edge holds all of it, or it is inside and no edge meets it.
bool in_region(const MovingPatch<double>& patch, const std::array<Dyadic, 2>& x,
               const std::array<Dyadic, 2>& radius, int dependent, Work& work) {
  if (patch.trim.empty()) return true;
  std::vector<Uv<Rational>> corners;
  for (const auto& [i, j] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const Rational a = (x[0] + Dyadic(i) * radius[0]).rational();
    const Rational b = (x[1] + Dyadic(j) * radius[1]).rational();
    const auto z = static_cast<size_t>(dependent);
    std::array<Rational, 3> barycentrics;  // w, u, v; of a tensor the last two alone mean something
    barycentrics[z] = 1 - a - b;
    barycentrics[(z + 1) % 3] = a;
    barycentrics[(z + 2) % 3] = b;
    corners.push_back({barycentrics[1], barycentrics[2]});
  }
  const Region region = region_of(patch.trim, corners, work);
  if (region != Region::kTouching) return region == Region::kInside;
  if (corners[0] == corners[2]) return true;
  return is_on_one_edge(patch.trim, corners, work);
}

Result<void> check_box_within(const Query& query, const ContactBox& box, Work& work) {
  std::array<Dyadic, 5> centre, radius;
  for (size_t i = 0; i < 5; ++i) centre[i] = Dyadic::exact(box.centre[i]);
  std::array<Dyadic, 3> rho;
  for (size_t i = 0; i < 3; ++i) {
    const int unknown = box.varied[i];
    if (unknown < 0 || unknown > ContactBox::kTime || (i > 0 && unknown <= box.varied[i - 1])) {
      return refuse_box("varied: not three unknowns in ascending order");
    }
    rho[i] = radius[static_cast<size_t>(unknown)] = Dyadic::exact(box.radius[i]);
    if (rho[i].sign() <= 0) return refuse_box(fmt::format("radius: {} is not > 0", box.radius[i]));
  }
  for (size_t s = 0; s < 2; ++s) {
    if (box.dependent[s] < 0 || box.dependent[s] > 2 ||
        !in_domain(query.patches[s].shape, {centre[2 * s], centre[2 * s + 1]},
                   {radius[2 * s], radius[2 * s + 1]}, box.dependent[s])) {
      return refuse_box(fmt::format("the box reaches out of the domain of patches[{}], {}", s,
                                    to_text(query.patches[s].shape)));
    }
    if (!in_region(query.patches[s], {centre[2 * s], centre[2 * s + 1]},
                   {radius[2 * s], radius[2 * s + 1]}, box.dependent[s], work)) {
      return refuse_box(fmt::format("the box is not known to lie in the trim of patches[{}]", s));
    }
  }
  if (centre[4] - radius[4] < Dyadic(0)) return refuse_box("the box reaches before t = 0");

  std::array<std::array<Dyadic, 3>, 3> inverse;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) inverse[i][j] = Dyadic::exact(box.inverse[i][j]);
  }
  const Dyadic determinant = dot(inverse[0], cross(inverse[1], inverse[2]));
  if (determinant.sign() == 0) return refuse_box("inverse: is singular");

  std::array<Dyadic, 3> remainder;
  for (const TaylorTerm<Dyadic>& term :
       taylor_terms<Dyadic>(query, box, kMostTaylorDegree, &work)) {
    Dyadic size(1);
    for (size_t i = 0; i < 3; ++i) {
      for (int p = 0; p < term.power[i]; ++p) size *= rho[i];
    }
    for (size_t i = 0; i < 3; ++i) {
      Dyadic value;
      for (size_t k = 0; k < 3; ++k) {
        const Dyadic& coefficient = term.coefficient[static_cast<Eigen::Index>(k)];
        work.charge(product_work(inverse[i][k], coefficient));
        value += inverse[i][k] * coefficient;
      }
      work.charge(product_work(value, size));
      if (term.degree() == 1 && term.power[i] == 1) value -= Dyadic(1);
      remainder[i] += abs(value) * size;
    }
  }
  for (size_t i = 0; i < 3; ++i) {
    if (remainder[i] > rho[i]) {
      return refuse_box(fmt::format("component {} may not change its sign across a radius of {}", i,
                                    box.radius[i]));
    }
  }
  return {};
}

}  // namespace

Result<void> check_box(const Query& query, const ContactBox& box, std::uint64_t most_work) {
  return within_work("truth.certificate.contact", most_work, check_box_within, query, box);
}

}  // namespace ccdfuzz
