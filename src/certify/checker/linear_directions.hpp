#pragma once

#include "certify/checker/linear_forms.hpp"

namespace ccdfuzz {

/// Directions along which a moving triangle may be farther from the origin than a distance d. They
/// are those to its corners, its edges and its plane. Whatever of it is nearest to the origin, the
/// way there is one of them. For corners a, b, c and e = b − a these are
///   a,  a·(e·e) − e·(a·e),  e × (c − a),  and the same of the others;
/// the last one is taken to either side. A direction n shows it where n·p > 0 and (n·p)² > d²·n·n
/// for all corners p. Where the triangle is farther away, the way to its nearest point shows it.
class LinearDirections {
 public:
  /// From 0 to 1 or 1 to 2: at an end, as points_of.
  LinearDirections(const Triangle& triangle, const Integer& distance, Work& work, size_t from = 0,
                   size_t to = 2)
      : p_(points_of(triangle, from, to)), work_(work) {
    const Form d(to - from, distance);
    squared_ = product(d, d, work);
  }

  /// True iff that direction, of 7, shows it where x > 0, y ≥ 0, or at that end: all coefficients
  /// have the right signs.
  bool show_farther(int direction) const {
    const auto i = static_cast<size_t>(direction) % 3;
    if (direction < 3) return shows(p_[i]);
    if (direction < 6) return shows(to_edge(p_[i], p_[(i + 1) % 3]));
    const FormVector n = cross_of(difference(p_[1], p_[0]), difference(p_[2], p_[0]), work_);
    return shows(n) || shows(difference(zeros(n), n));
  }

 private:
  static FormVector difference(const FormVector& a, const FormVector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static FormVector zeros(const FormVector& like) {
    const Form zero(like[0].size());
    return {zero, zero, zero};
  }

  FormVector to_edge(const FormVector& a, const FormVector& b) const {
    const FormVector e = difference(b, a);
    const Form squared = dot_of(e, e, work_), along = dot_of(a, e, work_);
    FormVector n;
    for (size_t k = 0; k < 3; ++k) {
      n[k] = product(a[k], squared, work_) - product(e[k], along, work_);
    }
    return n;
  }

  bool shows(const FormVector& n) const {
    std::array<Form, 3> heights;
    for (size_t i = 0; i < 3; ++i) {
      heights[i] = dot_of(n, p_[i], work_);
      if (!is_strictly(heights[i], 1, false)) return false;
    }
    const Form least = product(squared_, dot_of(n, n, work_), work_);
    return std::ranges::all_of(heights, [&](const Form& h) {
      return is_strictly(product(h, h, work_) - least, 1, false);
    });
  }

  std::array<FormVector, 3> p_;
  Form squared_;  ///< d²·(x + y)²
  Work& work_;
};

}  // namespace ccdfuzz
