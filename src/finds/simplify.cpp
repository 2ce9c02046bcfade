#include "finds/simplify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "bezier/bernstein.hpp"
#include "case/scale.hpp"
#include "fuzz/mutator/repair.hpp"

namespace ccdfuzz {

namespace {

using Offer = std::function<bool(const Contact&)>;

constexpr std::array kSides = {std::size_t{0}, std::size_t{1}};

std::uint64_t bits_of(const Dyadic& x) {
  return x.sign() == 0 ? 0 : mpz_sizeinbase(x.mantissa().get_mpz_t(), 2);
}

/// The one number of the patch's control points at its contact, if doubles hold it: the patch as a
/// point.
std::optional<MovingPatch<double>> as_point(const Contact& q, std::size_t side) {
  MovingPatch<double> patch = q.query.patches[side];
  if (!patch.weights.empty()) return std::nullopt;  // offer_weights takes them away
  const std::vector<Dyadic> weights = q.weights(static_cast<int>(side));
  MovingPatch<double> point{Shape::point(), {{0, 0, 0}}, {}};
  (patch.has_ends() ? point.ends : point.velocities) = {{0, 0, 0}};
  for (const PatchField array : kPatchFields) {
    for (int k = 0; k < 3; ++k) {
      Dyadic sum;
      for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += weights[i] * Dyadic::exact(array(patch)[i][k]);
      }
      const std::optional<double> x = sum.to_double_exactly();
      if (!x) return std::nullopt;
      array(point)[0][k] = *x;
    }
  }
  return point;
}

/// The patch of another shape of the same kind whose control points are those of this one that lie
/// nearest in the net.
MovingPatch<double> thinned(const MovingPatch<double>& patch, const Shape& to) {
  const Shape& from = patch.shape;
  MovingPatch<double> out{to, {}, {}};
  const auto at = [](int i, int n, int m) { return m == 0 ? 0 : (i * n + m / 2) / m; };
  for (int i = 0; i <= to.n; ++i) {
    const int last = to.kind == ShapeKind::kTriangle ? to.n - i
                     : to.kind == ShapeKind::kTensor ? to.m
                                                     : 0;
    for (int j = 0; j <= last; ++j) {
      const int from_i = at(i, from.n, to.n);
      int from_j = to.kind == ShapeKind::kTensor ? at(j, from.m, to.m) : at(j, from.n, to.n);
      if (to.kind == ShapeKind::kTriangle) from_j = std::min(from_j, from.n - from_i);
      const auto index = static_cast<std::size_t>(from.index(from_i, from_j));
      out.positions.push_back(patch.positions[index]);
      (patch.has_ends() ? out.ends : out.velocities).push_back(patch.moves()[index]);
      if (!patch.weights.empty()) out.weights.push_back(patch.weights[index]);
    }
  }
  return out;
}

/// No weights, or equal ones; powers of two; of few bits.
void offer_weights(const Contact& q, const Offer& offer) {
  for (const std::size_t side : kSides) {
    const auto with = [&](const auto& changed) {
      Contact next = q;
      std::vector<double>& weights = next.query.patches[side].weights;
      changed(weights);
      return weights == q.query.patches[side].weights || offer(next);
    };
    if (q.query.patches[side].weights.empty()) continue;
    if (with([](auto& weights) { weights.clear(); })) continue;
    if (with([](auto& weights) { std::ranges::fill(weights, 1); })) continue;
    for (const int bits : {1, 2, 3, 8}) {
      const auto cut = [bits](auto& weights) {
        for (double& w : weights) w = with_bits(w, bits, std::trunc);
      };
      if (with(cut)) break;
    }
    for (std::size_t i = 0; i < q.query.patches[side].weights.size(); ++i) {
      for (const double w : {1.0, 2.0, 0.5}) {
        if (with([&](auto& weights) { weights[i] = w; })) break;
      }
    }
  }
}

/// No trim; a loop less; a vertex less; vertices of few bits.
void offer_trims(const Contact& q, const Offer& offer) {
  for (const std::size_t side : kSides) {
    const Trim& now = q.query.patches[side].trim;
    const auto with = [&](const auto& changed) {
      Contact next = q;
      changed(next.query.patches[side].trim);
      return next.query.patches[side].trim == now || offer(next);
    };
    if (now.empty() || with([](Trim& trim) { trim.clear(); })) continue;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (with([i](Trim& trim) { trim.erase(trim.begin() + static_cast<std::ptrdiff_t>(i)); })) {
        break;
      }
      for (std::size_t j = 0; j < now[i].size(); ++j) {
        const auto drop = [&](Trim& trim) {
          trim[i].erase(trim[i].begin() + static_cast<std::ptrdiff_t>(j));
        };
        if (with(drop)) return;  // places are others now
        for (const int bits : {1, 2, 3, 8}) {
          const auto cut = [&](Trim& trim) {
            for (double& x : trim[i][j]) x = with_bits(x, bits, std::trunc);
          };
          if (with(cut)) break;
        }
      }
    }
  }
}

/// Velocities in place of ends, where the motion stays the same.
void offer_velocities(const Contact& q, const Offer& offer) {
  if (!has_ends(q.query)) return;
  if (const std::optional<Query> query = with_velocities(q.query)) {
    Contact next = q;
    next.query = *query;
    offer(next);
  }
}

void offer_shapes(const Contact& q, const Offer& offer) {
  for (const std::size_t side : kSides) {
    if (const auto point = as_point(q, side)) {
      if (q.query.patches[side].shape.kind != ShapeKind::kPoint) {
        Contact next = q;
        next.query.patches[side] = *point;
        next.uv[side] = {Dyadic(), Dyadic()};
        if (offer(next)) continue;
      }
    }
    // An edge of it, as a curve; the contact stays where it lies on one.
    const Shape shape = q.query.patches[side].shape;
    if (shape.kind == ShapeKind::kTriangle || shape.kind == ShapeKind::kTensor) {
      for (const bool along_u : {true, false}) {
        const int degree = along_u || shape.kind == ShapeKind::kTriangle ? shape.n : shape.m;
        Contact next = q;
        MovingPatch<double>& curve = next.query.patches[side];
        const MovingPatch<double>& patch = q.query.patches[side];
        curve = {Shape::curve(degree), {}, {}};
        for (int i = 0; i <= degree; ++i) {
          const auto index =
              static_cast<std::size_t>(along_u ? shape.index(i, 0) : shape.index(0, i));
          curve.positions.push_back(patch.positions[index]);
          (patch.has_ends() ? curve.ends : curve.velocities).push_back(patch.moves()[index]);
          if (!patch.weights.empty()) curve.weights.push_back(patch.weights[index]);
        }
        next.uv[side] = {q.uv[side][along_u ? 0 : 1], Dyadic()};
        if (offer(next)) break;
      }
    }
    for (int degree = 1;
         degree < std::max(q.query.patches[side].shape.n, q.query.patches[side].shape.m);
         ++degree) {
      const MovingPatch<double>& patch = q.query.patches[side];
      Shape lower = patch.shape;
      lower.n = std::min(lower.n, degree);
      lower.m = std::min(lower.m, degree);
      Contact next = q;
      next.query.patches[side] = thinned(patch, lower);
      if (offer(next)) break;
    }
  }
}

/// Space and time in units of powers of two in which the numbers are around 1; the origin where a
/// control point is.
void offer_units(const Contact& q, const Offer& offer) {
  for (const PatchField array : kPatchFields) {
    Contact next = q;
    const Vec3<double> by = array(next.query.patches[0])[0];
    bool exact = true;
    for (MovingPatch<double>& patch : next.query.patches) {
      for (Vec3<double>& p : array(patch)) exact = exact && add_exactly(p, -exact_dyadic(by));
    }
    if (exact) offer(next);
  }
  const auto scale = [](Contact& next, PatchField array, int shift) {
    for (MovingPatch<double>& patch : next.query.patches) {
      for (Vec3<double>& p : array(patch)) {
        for (int k = 0; k < 3; ++k) {
          const double scaled = std::ldexp(p[k], shift);
          if (!std::isfinite(scaled) || std::ldexp(scaled, -shift) != p[k]) return false;
          p[k] = scaled;
        }
      }
    }
    return true;
  };
  const double largest = largest_coordinate(q.query);
  if (const int shift = largest == 0 ? 0 : -std::ilogb(largest); shift != 0) {
    Contact next = q;
    next.query.separation = std::ldexp(q.query.separation, shift);
    const bool is_exact = std::ldexp(next.query.separation, -shift) == q.query.separation;
    if (is_exact && scale(next, kPatchFields[0], shift) && scale(next, kPatchFields[1], shift))
      offer(next);
  }
  if (q.query.t_max > 0 && !has_ends(q.query)) {
    if (const int shift = -std::ilogb(q.query.t_max); shift != 0) {
      Contact next = q;
      next.query.t_max = std::ldexp(q.query.t_max, shift);
      next.t = q.t.scaled(shift);
      if (scale(next, kPatchFields[1], -shift)) offer(next);
    }
  }
}

/// None, or of few bits.
void offer_separations(const Contact& q, const Offer& offer) {
  for (const int bits : {0, 1, 3, 8}) {
    Contact next = q;
    next.query.separation = with_bits(q.query.separation, bits, std::trunc);
    if (next.query.separation == q.query.separation || offer(next)) return;
  }
}

void offer_times(const Contact& q, const Offer& offer) {
  Contact next = q;
  if (const auto t = q.t.to_double_exactly()) {
    next.query.t_max = *t;
    offer(next);
  }
  for (const double t_max : {1.0, with_bits(q.query.t_max, 1, std::trunc) * 2}) {
    next = q;
    next.query.t_max = t_max;
    offer(next);
  }
  // The contact at a simpler time and place; where that breaks it, it is repaired.
  for (const double t : {0.0, 1.0, 0.5}) {
    next = q;
    next.t = Dyadic::exact(t);
    offer(next);
  }
  for (const std::size_t side : kSides) {
    for (const double u : {0.0, 1.0, 0.5, 0.25}) {
      for (const double v : {0.0, 1.0, 0.5, 0.25}) {
        const Shape& shape = q.query.patches[side].shape;
        if (shape.parameter_count() < 2 && v != 0) continue;
        if (shape.kind == ShapeKind::kPoint || (shape.kind == ShapeKind::kTriangle && u + v > 1)) {
          continue;
        }
        next = q;
        next.uv[side] = {Dyadic::exact(u), Dyadic::exact(v)};
        offer(next);
      }
    }
  }
}

/// All numbers of few bits; all velocities of a patch 0, or all equal; all positions.
void offer_wholesale(const Contact& q, const Offer& offer) {
  for (const int bits : {0, 1, 2, 3, 5, 8, 12, 18, 26}) {
    Contact next = q;
    for (MovingPatch<double>& patch : next.query.patches) {
      for_each_coordinate(patch, [bits](double& x) { x = with_bits(x, bits, std::trunc); });
    }
    if (offer(next)) break;
  }
  for (const PatchField array : {kPatchFields[1], kPatchFields[0]}) {
    for (const std::size_t side : kSides) {
      for (const bool to_zero : {true, false}) {
        Contact next = q;
        Points<double>& points = array(next.query.patches[side]);
        const Vec3<double> value = to_zero ? Vec3<double>{0, 0, 0} : points[0];
        for (Vec3<double>& p : points) p = value;
        if (offer(next)) break;
      }
      for (int k = 0; k < 3; ++k) {
        Contact next = q;
        for (Vec3<double>& p : array(next.query.patches[side])) p[k] = 0;
        offer(next);
      }
    }
  }
}

void offer_point_by_point(const Contact& q, const Offer& offer) {
  for (const std::size_t side : kSides) {
    for (std::size_t i = 0; i < q.query.patches[side].positions.size(); ++i) {
      for (const std::size_t other : {std::size_t{0}, i == 0 ? std::size_t{0} : i - 1}) {
        if (other == i) continue;
        Contact next = q;
        MovingPatch<double>& patch = next.query.patches[side];
        patch.positions[i] = patch.positions[other];
        patch.moves()[i] = patch.moves()[other];
        if (offer(next)) break;
      }
      for (const PatchField array : {kPatchFields[1], kPatchFields[0]}) {
        Contact next = q;
        array(next.query.patches[side])[i] = {0, 0, 0};
        if (offer(next)) continue;
        for (int k = 0; k < 3; ++k) {
          const auto number = [&](Contact& of) -> double& {
            return array(of.query.patches[side])[i][k];
          };
          next = q;
          const auto now = static_cast<int>(bits_of(Dyadic::exact(number(next))));
          if (now == 0) continue;
          for (int bits = 0; bits < now; bits = bits < 2 ? bits + 1 : bits * 2) {
            next = q;
            number(next) = with_bits(number(next), bits, std::trunc);
            if (offer(next)) break;
          }
        }
      }
    }
  }
}

}  // namespace

Simplicity simplicity_of(const Contact& q) {
  Simplicity s;
  s.size = size_of(q.query);
  s.witness_bits = bits_of(q.t);
  for (const Uv<Dyadic>& uv : q.uv) s.witness_bits += bits_of(uv[0]) + bits_of(uv[1]);
  for (const MovingPatch<double>& patch : q.query.patches) {
    std::set<std::array<double, 6>> different;
    for (std::size_t i = 0; i < patch.positions.size(); ++i) {
      const Vec3<double>&p = patch.positions[i], &v = patch.moves()[i];
      different.insert({p[0], p[1], p[2], v[0], v[1], v[2]});
    }
    // The number of control points counts, too: fewer are simpler even where they coincide.
    s.different_points += 64 * patch.positions.size() + different.size();
    // Ends, weights and loops are more than velocities, which every method takes.
    s.different_points += patch.has_ends() ? 32 : 0;
    s.different_points += patch.weights.empty() ? 0 : 32;
    for (const auto& loop : patch.trim) s.different_points += 32 + loop.size();
    for_each_coordinate(patch, [&](double x) {
      if (x != 0) s.exponents += static_cast<std::uint64_t>(std::abs(std::ilogb(x)));
    });
  }
  return s;
}

void offer_simpler(const Contact& current, const Offer& offer) {
  offer_velocities(current, offer);
  offer_trims(current, offer);
  offer_weights(current, offer);
  offer_shapes(current, offer);
  offer_wholesale(current, offer);
  offer_separations(current, offer);
  offer_times(current, offer);
  offer_units(current, offer);
  offer_point_by_point(current, offer);
}

}  // namespace ccdfuzz
