#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "certify/checker/work.hpp"

namespace ccdfuzz {

/// Σ c_i·x^(n−i)·y^i. With x = 1 − s, y = s the c_i are, up to binomials, its coefficients of
/// Bernstein; with x = 1, y = t it is an ordinary polynomial.
using Form = std::vector<Integer>;

inline Form product(const Form& a, const Form& b, Work& work) {
  Form out(a.size() + b.size() - 1);
  for (size_t i = 0; i < a.size(); ++i) {
    for (size_t j = 0; j < b.size(); ++j) {
      work.charge(product_work(a[i], b[j]));
      out[i + j] += a[i] * b[j];
    }
  }
  return out;
}
inline Form operator+(Form a, const Form& b) {
  for (size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}
inline Form operator-(Form a, const Form& b) {
  for (size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

using FormVector = std::array<Form, 3>;

inline Form dot_of(const FormVector& a, const FormVector& b, Work& work) {
  return product(a[0], b[0], work) + product(a[1], b[1], work) + product(a[2], b[2], work);
}

inline FormVector cross_of(const FormVector& a, const FormVector& b, Work& work) {
  const auto component = [&](size_t i, size_t j) {
    return product(a[i], b[j], work) - product(a[j], b[i], work);
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

/// A triangle: x·at[0] + y·at[1] of each component of each corner.
using Corner = std::array<std::array<Integer, 2>, 3>;
using Triangle = std::array<Corner, 3>;

/// Its corners in forms of x and y.
inline std::array<FormVector, 3> points_of(const Triangle& triangle) {
  std::array<FormVector, 3> out;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t k = 0; k < 3; ++k) out[i][k].assign(triangle[i][k].begin(), triangle[i][k].end());
  }
  return out;
}

/// An end of the range x, y ≥ 0: y = 0 or x = 0.
enum class End : std::uint8_t { kStart, kStop };

inline int sign_at(End end, const Form& f) {
  return sgn(end == End::kStart ? f.front() : f.back());
}

/// A form that has on its range the signs of f on the half of f's that begins or ends at `end`:
/// f(2x + y, y) or f(x, x + 2y).
inline Form half_of(Form f, End end, Work& work) {
  if (end == End::kStart) std::ranges::reverse(f);
  // f is Σ f_k·z^k now, z = x/y or y/x. By Horner's rule this is f(z + 1), and then f(2z + 1).
  for (size_t i = 0; i + 1 < f.size(); ++i) {
    for (size_t k = f.size() - 1; k-- > i;) {
      work.charge(product_work(f[k + 1], 1.0));
      f[k] += f[k + 1];
    }
  }
  for (size_t k = 1; k < f.size(); ++k) f[k] <<= k;
  if (end == End::kStart) std::ranges::reverse(f);
  return f;
}

inline bool has_no_sign(const Form& f, int sign) {
  return std::ranges::none_of(f, [sign](const Integer& c) { return sgn(c) == sign; });
}

/// sign·f > 0 where x > 0, y ≥ 0, and at x = 0 too if `closed`.
inline bool is_strictly(const Form& f, int sign, bool closed) {
  return has_no_sign(f, -sign) && sgn(f.front()) == sign && (!closed || sgn(f.back()) == sign);
}

}  // namespace ccdfuzz
