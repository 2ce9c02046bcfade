#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>

#include "ccd/certified/normalise.hpp"
#include "certify/checker/check_box.hpp"
#include "certify/checker/taylor.hpp"
#include "certify/oracle/find_contact.hpp"

namespace ccdfuzz {

namespace {

constexpr int kTime = ContactBox::kTime;

/// A box of no size at the guess. In a triangle the largest barycentric is the dependent one,
/// so that edges are fixed unknowns.
ContactBox box_at(const Query& query, const ContactGuess& guess, double near_zero) {
  ContactBox box;
  for (size_t s = 0; s < 2; ++s) {
    const Shape& shape = query.patches[s].shape;
    double* const x = &box.centre[2 * s];
    if (shape.kind == ShapeKind::kTriangle) {
      const auto& [u, v] = guess.uv[s];
      std::array<double, 3> b = {1 - u - v, u, v};
      for (double& y : b) y = y <= near_zero ? 0 : y;
      const auto z = static_cast<size_t>(std::max_element(b.begin(), b.end()) - b.begin());
      box.dependent[s] = static_cast<int>(z);
      x[0] = b[(z + 1) % 3], x[1] = b[(z + 2) % 3];
      continue;
    }
    for (int k = 0; k < shape.parameter_count(); ++k) {
      x[k] = guess.uv[s][static_cast<size_t>(k)];
      if (x[k] <= near_zero) x[k] = 0;
      if (x[k] >= 1 - near_zero) x[k] = 1;
    }
  }
  return box;
}

/// True iff the centre has room of `margin` on all sides in the unknowns that vary.
bool has_room(const Query& query, const ContactBox& box, double margin) {
  std::array<double, 5> room{};
  for (const int i : box.varied) room[static_cast<size_t>(i)] = margin;
  for (size_t s = 0; s < 2; ++s) {
    const double x = box.centre[2 * s], y = box.centre[2 * s + 1];
    const double rx = room[2 * s], ry = room[2 * s + 1];
    if (x - rx < 0 || y - ry < 0 || x + rx > 1 || y + ry > 1) return false;
    if (query.patches[s].shape.kind == ShapeKind::kTriangle && x + y + rx + ry > 1) return false;
  }
  return box.centre[kTime] - room[4] >= 0;
}

using Matrix3 = Eigen::Matrix3d;

struct Linear {
  Vec3<double> value;
  Matrix3 slope;
};

Linear linearise(const Query& query, const ContactBox& box) {
  Linear out{Vec3<double>::Zero(), Matrix3::Zero()};
  for (const TaylorTerm<double>& term : taylor_terms<double>(query, box, 1)) {
    if (term.degree() == 0) out.value = term.coefficient;
    for (int i = 0; i < 3; ++i) {
      if (term.degree() == 1 && term.power[static_cast<size_t>(i)] == 1) {
        out.slope.col(i) = term.coefficient;
      }
    }
  }
  return out;
}

/// Newton's method in the varied unknowns; leaves the inverse of the last slope in the box.
/// scaled: the query with lengths and times of magnitude 1.
bool converge(const Query& scaled, ContactBox& box) {
  constexpr int kSteps = 16;
  constexpr double kConverged = 0x1p-46, kFar = 0.25;
  for (int step = 0; step < kSteps; ++step) {
    const Linear f = linearise(scaled, box);
    const double columns = f.slope.col(0).norm() * f.slope.col(1).norm() * f.slope.col(2).norm();
    constexpr double kLeastAngle = 1e-9;
    if (!(std::abs(f.slope.determinant()) > kLeastAngle * columns)) return false;
    const Matrix3 inverse = f.slope.inverse();
    const Vec3<double> move = inverse * f.value;
    if (!move.allFinite() || move.cwiseAbs().maxCoeff() > kFar) return false;
    for (size_t i = 0; i < 3; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      box.centre[static_cast<size_t>(box.varied[i])] -= move[k];
      for (size_t j = 0; j < 3; ++j) box.inverse[i][j] = inverse(k, static_cast<Eigen::Index>(j));
    }
    if (move.cwiseAbs().maxCoeff() < kConverged) return has_room(scaled, box, 0);
  }
  return false;
}

/// The query that normalise makes, as a query: lengths times 2^space, times over 2^time.
Query scaled_query(const certified::NormalisedQuery& normalised) {
  Query out;
  for (size_t s = 0; s < 2; ++s) {
    out.patches[s].shape = normalised.shapes[s];
    for (const std::array<double, 6>& c : normalised.controls[s]) {
      out.patches[s].positions.push_back({c[0], c[1], c[2]});
      out.patches[s].velocities.push_back({c[3], c[4], c[5]});
    }
    out.patches[s].weights = normalised.weights[s];
  }
  out.t_max = normalised.t_max;
  return out;
}

/// The box of the scaled query in the query's own units.
ContactBox unscaled(ContactBox box, int time, int space) {
  box.centre[kTime] = std::ldexp(box.centre[kTime], time);
  for (size_t i = 0; i < 3; ++i) {
    const int shift = box.varied[i] == kTime ? time : 0;
    box.radius[i] = std::ldexp(box.radius[i], shift);
    for (double& y : box.inverse[i]) y = std::ldexp(y, space + shift);
  }
  return box;
}

}  // namespace

std::optional<ContactBox> find_contact_box(const Query& query, const ContactGuess& guess) {
  certified::NormalisedQuery normalised;
  certified::normalise(query, normalised);
  const Query scaled = scaled_query(normalised);
  const Rational t_max = exact(query.t_max);
  std::optional<ContactBox> best;
  const auto good_enough = [&] {
    constexpr double kLate = 0x1p-16;  // of the horizon
    return best && best->until() <= exact(guess.t) + exact(kLate) * t_max;
  };
  for (const double near_zero : {4 * guess.width, 0.0}) {
    // Sets that contain the time come first, as contacts that begin transversally are found by
    // them: the time is the top bit.
    for (unsigned set = 31; set > 0 && !good_enough(); --set) {
      if (std::popcount(set) != 3) continue;
      ContactBox start = box_at(query, guess, near_zero);
      unsigned left = set;
      for (int& unknown : start.varied) {
        unknown = std::countr_zero(left);
        left &= left - 1;
      }
      const auto varies = [&](int i) {
        return i == kTime ||
               i % 2 < query.patches[static_cast<size_t>(i / 2)].shape.parameter_count();
      };
      if (!std::ranges::all_of(start.varied, varies)) continue;
      start.centre[kTime] = std::ldexp(guess.t, -normalised.time);
      if (!converge(scaled, start)) continue;
      for (int exponent = -44; exponent <= -6; exponent += 4) {
        ContactBox box = start;
        box.radius.fill(std::ldexp(1.0, exponent));
        if (!has_room(scaled, box, box.radius[0])) break;
        // The checker expands w2·N1 − w1·N2, which scales with space and both weights.
        const int scale =
            normalised.space + normalised.weight_shift[0] + normalised.weight_shift[1];
        box = unscaled(box, normalised.time, scale);
        bool finite = true;
        for (size_t i = 0; i < 3; ++i) {
          finite = finite && box.radius[i] > 0;
          for (const double y : box.inverse[i]) finite = finite && std::isfinite(y);
        }
        if (!finite || box.until() > t_max) break;
        if (best && best->until() <= box.until()) break;
        if (!check_box(query, box)) continue;
        best = box;
        break;
      }
    }
    if (best) break;
  }
  return best;
}

}  // namespace ccdfuzz
