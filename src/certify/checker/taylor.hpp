#pragma once

#include "case/certificate.hpp"
#include "case/query.hpp"
#include "certify/checker/polar.hpp"

namespace ccdfuzz {

/// coefficient · Π δ_i^power_i, δ the offsets of the three varied unknowns of a contact box.
template <class S>
struct TaylorTerm {
  Vec3<S> coefficient;
  std::array<int, 3> power{};

  int degree() const { return power[0] + power[1] + power[2]; }
};

namespace taylor_detail {

/// One weight vector for a patch's parameter at the centre, and one along each of its unknowns.
template <class S>
struct Directions {
  Weights<S> at, along_x, along_y;
};

template <class S>
Directions<S> triangle_directions(const S& x, const S& y, int dependent) {
  const auto z = static_cast<size_t>(dependent);
  const size_t i = (z + 1) % 3, j = (z + 2) % 3;
  Directions<S> d{{S(0), S(0), S(0)}, {S(0), S(0), S(0)}, {S(0), S(0), S(0)}};
  d.at[i] = x, d.at[j] = y, d.at[z] = S(1) - x - y;
  d.along_x[i] = S(1), d.along_x[z] = S(-1);
  d.along_y[j] = S(1), d.along_y[z] = S(-1);
  return d;
}

/// count copies of `along`, the rest `at`.
template <class S>
std::vector<Weights<S>> arguments(int degree, const Weights<S>& at, int count,
                                  const Weights<S>& along, int more = 0,
                                  const Weights<S>& other = {}) {
  std::vector<Weights<S>> out(static_cast<size_t>(degree), at);
  std::fill_n(out.begin(), count, along);
  std::fill_n(out.begin() + count, more, other);
  return out;
}

/// coefficient · Π δ_i^power_i of w·S and of w, homogeneous, of one patch.
template <class S>
struct PatchTerm {
  Vec3<S> numerator;
  S weight;
  std::array<int, 3> power{};
};

template <class S>
S product_of(const S& a, const S& b, Work* work) {
  if (work != nullptr) work->charge(product_work(a, b));
  return S(a * b);
}

}  // namespace taylor_detail

/// No expansion has a higher degree: two parameters of each patch, of numerator or weight, and the
/// time.
inline constexpr int kMostTaylorDegree = 4 * kMaxDegree + 1;

/// The expansion of S1 − S2 about the centre of a contact box, in its varied unknowns, the others
/// fixed. Where a patch is rational, S = N/w, it is that of w2·N1 − w1·N2, which has the same zeros
/// as w1·w2 > 0. All terms up to max_degree. The blossom is multilinear. So the coefficient of x^i
/// y^j is the blossom at i directions along x, j along y and the centre for the rest, times a
/// multinomial.
template <class S>
std::vector<TaylorTerm<S>> taylor_terms(const Query& query, const ContactBox& box,
                                        int max_degree = kMostTaylorDegree, Work* work = nullptr) {
  using namespace taylor_detail;
  /// Place of an unknown among the varied ones, or −1.
  const auto place = [&](int unknown) {
    const auto found = std::find(box.varied.begin(), box.varied.end(), unknown);
    return found == box.varied.end() ? -1 : static_cast<int>(found - box.varied.begin());
  };
  const S time = from_double<S>(box.centre[ContactBox::kTime]);
  const int time_place = place(ContactBox::kTime);
  std::vector<TaylorTerm<S>> terms;
  const auto add = [&](const std::array<int, 3>& power, const Vec3<S>& value) {
    for (TaylorTerm<S>& term : terms) {
      if (term.power != power) continue;
      for (int k = 0; k < 3; ++k) term.coefficient[k] += value[k];
      return;
    }
    terms.push_back({value, power});
  };
  const bool rational = is_rational(query);
  Polar<S> polar(work, rational);
  std::array<std::vector<PatchTerm<S>>, 2> of_patch;
  for (size_t s = 0; s < 2; ++s) {
    const MovingPatch<double>& patch = query.patches[s];
    const Shape& shape = patch.shape;
    const MovingNet<S> net = moving_net<S>(patch);
    const int px = place(static_cast<int>(2 * s)), py = place(static_cast<int>(2 * s + 1));
    const S x = from_double<S>(box.centre[2 * s]), y = from_double<S>(box.centre[2 * s + 1]);
    const bool triangle = shape.kind == ShapeKind::kTriangle;
    const int most_x = px < 0 ? 0 : std::min(shape.n, max_degree);
    for (int i = 0; i <= most_x; ++i) {
      const int degree_y = shape.last_column(i);
      const int most_y = py < 0 ? 0 : std::min(degree_y, max_degree - i);
      for (int j = 0; j <= most_y; ++j) {
        std::vector<Weights<S>> first, second;
        if (triangle) {
          const Directions<S> d = triangle_directions<S>(x, y, box.dependent[s]);
          first = arguments<S>(shape.n, d.at, i, d.along_x, j, d.along_y);
        } else {
          const Weights<S> along = {S(-1), S(1), S(0)};
          first = arguments<S>(shape.n, {S(1) - x, x, S(0)}, i, along);
          second = arguments<S>(shape.m, {S(1) - y, y, S(0)}, j, along);
        }
        const Moving<S>& b = polar(shape, net, first, second);
        const S factor(choose(shape.n, i) * choose(degree_y, j));
        std::array<int, 3> power{};
        if (px >= 0) power[static_cast<size_t>(px)] = i;
        if (py >= 0) power[static_cast<size_t>(py)] = j;
        of_patch[s].push_back({Vec3<S>(factor * (b[0] + time * b[3]), factor * (b[1] + time * b[4]),
                                       factor * (b[2] + time * b[5])),
                               S(factor * b[kWeight]), power});
        if (time_place >= 0 && i + j < max_degree) {
          ++power[static_cast<size_t>(time_place)];
          of_patch[s].push_back(
              {Vec3<S>(factor * b[3], factor * b[4], factor * b[5]), S(0), power});
        }
      }
    }
  }
  if (!rational) {
    for (const PatchTerm<S>& term : of_patch[0]) add(term.power, term.numerator);
    for (const PatchTerm<S>& term : of_patch[1]) add(term.power, -term.numerator);
    return terms;
  }
  for (const PatchTerm<S>& a : of_patch[0]) {
    for (const PatchTerm<S>& b : of_patch[1]) {
      TaylorTerm<S> both;
      for (size_t k = 0; k < 3; ++k) both.power[k] = a.power[k] + b.power[k];
      if (both.degree() > max_degree) continue;
      for (int k = 0; k < 3; ++k) {
        both.coefficient[k] = product_of(a.numerator[k], b.weight, work);
        both.coefficient[k] -= product_of(b.numerator[k], a.weight, work);
      }
      add(both.power, both.coefficient);
    }
  }
  return terms;
}

}  // namespace ccdfuzz
