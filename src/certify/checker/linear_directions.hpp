#pragma once

#include "certify/checker/linear_forms.hpp"

namespace ccdfuzz {

/// Points of a moving triangle that may be nearest to the origin, and directions along which it may
/// be farther away than a distance d. For corners a, b, c they are the corners, the feet of the
/// origin on the lines of the edges, and that on the plane. A foot is Σ w·p / Σ w with the weights
///   b·(b − a) of a, a·(a − b) of b;  (b×c)·n of a, and so on, with n = a×b + b×c + c×a.
/// It is of the edge or of the triangle iff the weights are ≥ 0, and w = 1 of a corner. The sums of
/// the weights are |b − a|² and |n|². Whatever of the triangle is nearest, it is one of the seven.
/// So are the ways there, which are the directions; n is taken to either side. A direction shows
/// the triangle farther away where x = direction·p > 0 and x² > d²·|direction|² for all corners p.
class LinearDirections {
 public:
  static constexpr int kCount = 7;

  /// Forms of a direction, all > 0 where it shows the triangle farther away.
  static constexpr size_t kForms = 6;

  /// distance: d as a form.
  LinearDirections(const Triangle& triangle, const Form& distance, Work& work)
      : p_(points_of(triangle)), squared_(product(distance, distance, work)), work_(work) {}

  /// Appends kForms for a direction. For the ways to the plane, there are those to either side.
  void add_forms(int direction, std::vector<Form>& out) const {
    if (direction < 3) return add_forms_along(p_[static_cast<size_t>(direction)], out);
    if (direction < 6) return add_forms_along(point_of(weights_of(direction)), out);
    add_forms_along(normal(), out);
    for (size_t i = 0; i < 3; ++i) {
      const Form& height = out[out.size() - kForms];
      out.push_back(Form(height.size()) - height);
    }
    for (size_t i = 0; i < 3; ++i) out.push_back(out[out.size() - kForms]);
  }

  /// What makes one of the points one of the triangle, no farther from the origin than d: all
  /// weights ≥ 0, their sum > 0, and |Σ w·p|² − d²·(Σ w)² ≤ 0.
  struct Nearness {
    std::array<Form, 3> weights;
    Form sum, excess;
  };
  Nearness nearness(int direction) const {
    Nearness out{weights_of(direction), {}, {}};
    out.sum = out.weights[0] + out.weights[1] + out.weights[2];
    const FormVector point = point_of(out.weights);
    out.excess =
        dot_of(point, point, work_) - product(squared_, product(out.sum, out.sum, work_), work_);
    return out;
  }

 private:
  /// n is that of (b − a) × (c − a).
  FormVector normal() const {
    const auto way = [&](size_t i) -> FormVector {
      return {p_[i][0] - p_[0][0], p_[i][1] - p_[0][1], p_[i][2] - p_[0][2]};
    };
    return cross_of(way(1), way(2), work_);
  }

  std::array<Form, 3> weights_of(int direction) const {
    const auto i = static_cast<size_t>(direction) % 3, j = (i + 1) % 3, k = (i + 2) % 3;
    std::array<Form, 3> w;
    if (direction < 3) {
      w[i] = {1}, w[j] = w[k] = {0};
    } else if (direction < 6) {
      const Form along = dot_of(p_[i], p_[j], work_);
      w[i] = dot_of(p_[j], p_[j], work_) - along;
      w[j] = dot_of(p_[i], p_[i], work_) - along;
      w[k].resize(along.size());
    } else {
      const FormVector n = normal();
      for (size_t c = 0; c < 3; ++c) {
        w[c] = dot_of(n, cross_of(p_[(c + 1) % 3], p_[(c + 2) % 3], work_), work_);
      }
    }
    return w;
  }

  /// Σ w·p.
  FormVector point_of(const std::array<Form, 3>& w) const {
    FormVector out;
    for (size_t k = 0; k < 3; ++k) out[k] = dot_of(w, {p_[0][k], p_[1][k], p_[2][k]}, work_);
    return out;
  }

  /// The heights of the corners along n, and their squares less d²·|n|².
  void add_forms_along(const FormVector& n, std::vector<Form>& out) const {
    const Form least = product(squared_, dot_of(n, n, work_), work_);
    for (size_t i = 0; i < 3; ++i) out.push_back(dot_of(n, p_[i], work_));
    for (size_t i = 0; i < 3; ++i) {
      const Form& height = out[out.size() - 3];
      out.push_back(product(height, height, work_) - least);
    }
  }

  std::array<FormVector, 3> p_;
  Form squared_;  ///< d²
  Work& work_;
};

}  // namespace ccdfuzz
