#pragma once

#include <array>
#include <span>
#include <vector>

#include "bezier/patch.hpp"
#include "certify/checker/work.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// A control point that moves: its position x, y, z, its velocity, and its weight. A rational
/// patch has homogeneous ones: the weight is multiplied into the others.
template <class S>
using Moving = std::array<S, 7>;
inline constexpr size_t kWeight = 6;

template <class S>
using MovingNet = std::vector<Moving<S>>;

/// Weights of the corners w, u, v of a triangle; of the ends 0 and 1 of a parameter, and nothing.
template <class S>
using Weights = std::array<S, 3>;

/// Blossoms of moving patches in any number type, exact if S is; keeps its scratch.
template <class S>
class Polar {
 public:
  /// work, if given, is charged for all that is done, and outlives this. rational: makes weights,
  /// too; otherwise the result has none.
  explicit Polar(Work* work = nullptr, bool rational = false)
      : work_(work), places_(rational ? kWeight + 1 : kWeight) {}

  /// net: shape.control_count() control points in Shape's order. One weight vector an argument: a
  /// triangle or a curve of degree n takes n in `first`, a tensor patch n in `first` (u) and m in
  /// `second` (v). Weights that sum to 1 are points, those that sum to 0 directions, and the
  /// blossom is linear in each. Valid until the next call.
  const Moving<S>& operator()(const Shape& shape, const MovingNet<S>& net,
                              std::span<const Weights<S>> first,
                              std::span<const Weights<S>> second) {
    net_ = net;
    if (shape.kind == ShapeKind::kTriangle) {
      for (int left = shape.n; left > 0; --left) {
        const Shape from = Shape::triangle(left), to = Shape::triangle(left - 1);
        for (int i = 0; i < left; ++i) {
          for (int j = 0; j < left - i; ++j) {  // to.index ≤ from.index of all later reads
            combine(first[left - 1], {from.index(i, j), from.index(i + 1, j), from.index(i, j + 1)},
                    to.index(i, j));
          }
        }
      }
      return net_[0];
    }
    for (int i = 0; i <= shape.n; ++i) {
      for (int left = shape.m; left > 0; --left) {
        for (int j = 0; j < left; ++j) {
          const int here = shape.index(i, j);
          combine(second[left - 1], {here, here + 1, -1}, here);
        }
      }
    }
    for (int left = shape.n; left > 0; --left) {
      for (int i = 0; i < left; ++i) {
        combine(first[left - 1], {shape.index(i, 0), shape.index(i + 1, 0), -1}, shape.index(i, 0));
      }
    }
    return net_[0];
  }

 private:
  void combine(const Weights<S>& weights, const std::array<int, 3>& from, int to) {
    for (S& x : sum_) x = 0;
    for (size_t c = 0; c < 3; ++c) {
      if (from[c] < 0 || weights[c] == 0) continue;
      const Moving<S>& p = net_[from[c]];
      for (size_t k = 0; k < places_; ++k) {
        if (work_ != nullptr) work_->charge(product_work(weights[c], p[k]));
        sum_[k] += weights[c] * p[k];
      }
    }
    std::swap(net_[to], sum_);
  }

  Work* work_;
  size_t places_;
  MovingNet<S> net_;
  Moving<S> sum_;
};

/// The control points of a patch. convert(x, moves) is x in S: of a position, or where `moves` of a
/// velocity or of what is subtracted to make one. It is linear in x. weigh(w): the weight in S, of
/// a rational patch; any positive multiple that is the same for all.
template <class S, class Convert, class Weigh>
MovingNet<S> moving_net(const MovingPatch<double>& patch, const Convert& convert,
                        const Weigh& weigh) {
  MovingNet<S> net(patch.positions.size());
  for (size_t i = 0; i < net.size(); ++i) {
    for (size_t k = 0; k < 3; ++k) {
      net[i][k] = convert(patch.positions[i][k], false);
      if (patch.has_ends()) {
        net[i][k + 3] = convert(patch.ends[i][k], true) - convert(patch.positions[i][k], true);
      } else {
        net[i][k + 3] = convert(patch.velocities[i][k], true);
      }
    }
    net[i][kWeight] = 1;
  }
  if (!patch.is_rational()) return net;
  for (size_t i = 0; i < net.size(); ++i) {
    for (S& x : net[i]) x *= weigh(patch.weights[i]);
  }
  return net;
}

/// The same in numbers that hold all doubles.
template <class S>
MovingNet<S> moving_net(const MovingPatch<double>& patch) {
  return moving_net<S>(
      patch, [](double x, bool) { return from_double<S>(x); }, from_double<S>);
}

}  // namespace ccdfuzz
