#include "finds/simplify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "bezier/bernstein.hpp"
#include "case/scale.hpp"
#include "fuzz/mutator/repair.hpp"
#include "generators/similar.hpp"

namespace ccdfuzz {

namespace {

/// How many significant bits are tried.
constexpr std::array kBits = {0, 1, 2, 3, 5, 8, 12, 18, 26};

constexpr std::array kSides = {std::size_t{0}, std::size_t{1}};

/// x with at most `bits` significant bits, rounded; 0 with none.
double with_bits(double x, int bits) {
  if (bits == 0 || x == 0) return 0;
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return std::ldexp(std::round(std::ldexp(fraction, bits)), exponent - bits);
}

std::uint64_t bits_of(const Dyadic& x) {
  return x.sign() == 0 ? 0 : mpz_sizeinbase(x.mantissa().get_mpz_t(), 2);
}

/// The one number of the patch's control points at its contact, if doubles hold it: the patch as a
/// point.
std::optional<MovingPatch<double>> as_point(const Contact& q, std::size_t side) {
  MovingPatch<double> patch = q.query.patches[side];
  if (!patch.weights.empty()) return std::nullopt;  // offer_weights takes them away
  const std::vector<Dyadic> weights = q.weights(side);
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
  const auto at = [](int i, int n, int m) { return m == 0 ? 0 : (i * n + m / 2) / m; };
  return picked(patch, to, [&](int i, int j) {
    const int from_i = at(i, from.n, to.n);
    if (to.kind == ShapeKind::kTensor) return from.index(from_i, at(j, from.m, to.m));
    const int from_j = at(j, from.n, to.n);
    return from.index(from_i,
                      to.kind == ShapeKind::kTriangle ? std::min(from_j, from.n - from_i) : from_j);
  });
}

/// No weights, or equal ones; one that is 1.
void offer_weights(const Contact& q, const Offer& offer) {
  for (const std::size_t side : kSides) {
    const auto weights = [side](Query & next) -> auto& {
      return next.patches[side].weights;
    };
    if (offer_changed(q, offer, [&](Query& next) { weights(next).clear(); })) continue;
    offer_changed(q, offer, [&](Query& next) { std::ranges::fill(weights(next), 1); });
    for (std::size_t i = 0; i < q.query.patches[side].weights.size(); ++i) {
      offer_changed(q, offer, [&](Query& next) { weights(next)[i] = 1; });
    }
  }
}

/// No trim; a loop less; a vertex less.
void offer_trims(const Contact& q, const Offer& offer) {
  for (const std::size_t side : kSides) {
    const auto trim = [side](Query& next) -> Trim& { return next.patches[side].trim; };
    const auto without = [](auto& items, std::size_t i) {
      items.erase(items.begin() + static_cast<std::ptrdiff_t>(i));
    };
    if (offer_changed(q, offer, [&](Query& next) { trim(next).clear(); })) continue;
    const Trim& now = q.query.patches[side].trim;
    for (std::size_t i = now.size(); i-- > 0;) {
      if (offer_changed(q, offer, [&](Query& next) { without(trim(next), i); })) continue;
      for (std::size_t j = now[i].size(); j-- > 0;) {
        offer_changed(q, offer, [&](Query& next) { without(trim(next)[i], j); });
      }
    }
  }
}

/// Velocities in place of ends, where the motion stays the same.
void offer_velocities(const Contact& q, const Offer& offer) {
  const auto query = has_ends(q.query) ? with_velocities(q.query) : std::nullopt;
  if (query) offer_changed(q, offer, [&](Query& next) { next = *query; });
}

void offer_shapes(const Contact& q, const Offer& offer) {
  for (const std::size_t side : kSides) {
    const auto point = as_point(q, side);
    if (point && q.query.patches[side].shape.kind != ShapeKind::kPoint) {
      Contact next = q;
      next.query.patches[side] = *point;
      next.uv[side] = {Dyadic(), Dyadic()};
      if (offer(next)) continue;
    }
    // An edge of it, as a curve; the contact stays where it lies on one.
    const Shape shape = q.query.patches[side].shape;
    if (shape.kind == ShapeKind::kTriangle || shape.kind == ShapeKind::kTensor) {
      for (const bool along_u : {true, false}) {
        const int degree = along_u || shape.kind == ShapeKind::kTriangle ? shape.n : shape.m;
        Contact next = q;
        next.query.patches[side] =
            picked(q.query.patches[side], Shape::curve(degree),
                   [&](int i, int) { return along_u ? shape.index(i, 0) : shape.index(0, i); });
        next.uv[side] = {q.uv[side][along_u ? 0 : 1], Dyadic()};
        if (offer(next)) break;
      }
    }
    for (int degree = 1;
         degree < std::max(q.query.patches[side].shape.n, q.query.patches[side].shape.m);
         ++degree) {
      const bool taken = offer_changed(q, offer, [&](Query& next) {
        MovingPatch<double>& patch = next.patches[side];
        Shape lower = patch.shape;
        lower.n = std::min(lower.n, degree);
        lower.m = std::min(lower.m, degree);
        patch = thinned(patch, lower);
      });
      if (taken) break;
    }
  }
}

/// The origin where a control point is, and moving with it; space and time in units of powers of
/// two in which the numbers are around 1.
void offer_units(const Contact& q, const Offer& offer) {
  const auto offer_similar = [&](const Similarity& change) {
    const std::optional<Query> query = similar(q.query, change);
    if (!query || *query == q.query) return;
    Contact next = q;
    next.query = *query;
    next.t = q.t.scaled(change.time);
    offer(next);
  };
  const auto unit_of = [](double largest) { return largest == 0 ? 0 : -std::ilogb(largest); };
  const MovingPatch<double>& first = q.query.patches[0];
  offer_similar({.shift = -first.positions[0]});
  offer_similar({.drift = -first.moves()[0]});
  offer_similar({.space = unit_of(largest_coordinate(q.query))});
  offer_similar({.time = unit_of(q.query.t_max)});
}

void offer_times(const Contact& q, const Offer& offer) {
  const double contact = q.t.to_double_exactly().value_or(q.query.t_max);
  for (const double t_max : {contact, 1.0, with_bits(q.query.t_max, 1) * 2}) {
    offer_changed(q, offer, [&](Query& next) { next.t_max = t_max; });
  }
  // The contact at a simpler time and place; where that breaks it, it is repaired.
  for (const double t : {0.0, 1.0, 0.5}) {
    Contact next = q;
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
        Contact next = q;
        next.uv[side] = {Dyadic::exact(u), Dyadic::exact(v)};
        offer(next);
      }
    }
  }
}

/// All velocities of a patch 0, or all equal; all positions.
void offer_wholesale(const Contact& q, const Offer& offer) {
  for (const PatchField array : {kPatchFields[1], kPatchFields[0]}) {
    for (const std::size_t side : kSides) {
      const auto points = [&](Query & next) -> auto& {
        return array(next.patches[side]);
      };
      const auto all = [&](bool to_zero) {
        return offer_changed(q, offer, [&](Query& next) {
          const Vec3<double> value = to_zero ? Vec3<double>{0, 0, 0} : points(next)[0];
          std::ranges::fill(points(next), value);
        });
      };
      if (!all(true)) all(false);
      for (int k = 0; k < 3; ++k) {
        offer_changed(q, offer, [&](Query& next) {
          for (Vec3<double>& p : points(next)) p[k] = 0;
        });
      }
    }
  }
}

/// A control point at the place of the first or of the one before; at the origin; at rest.
void offer_point_by_point(const Contact& q, const Offer& offer) {
  for (const std::size_t side : kSides) {
    for (std::size_t i = 0; i < q.query.patches[side].positions.size(); ++i) {
      for (const std::size_t other : {std::size_t{0}, i == 0 ? std::size_t{0} : i - 1}) {
        const bool taken = offer_changed(q, offer, [&](Query& next) {
          MovingPatch<double>& patch = next.patches[side];
          patch.positions[i] = patch.positions[other];
          patch.moves()[i] = patch.moves()[other];
        });
        if (taken) break;
      }
      for (const PatchField array : {kPatchFields[1], kPatchFields[0]}) {
        offer_changed(q, offer, [&](Query& next) { array(next.patches[side])[i] = {0, 0, 0}; });
      }
    }
  }
}

/// Numbers of few bits: all of the patches.
void offer_rounded(const Contact& q, const Offer& offer) {
  for (const int bits : kBits) {
    const bool taken = offer_changed(q, offer, [&](Query& next) {
      for (MovingPatch<double>& patch : next.patches) {
        const auto round = [&](double& x) { x = with_bits(x, bits); };
        for_each_coordinate(patch, round);
        for_each_turn_number(patch, round);
      }
    });
    if (taken) break;
  }
}

/// Each number of few bits.
void offer_numbers(const Contact& q, const Offer& offer) {
  bool is_there = true;
  for (std::size_t i = 0; is_there; ++i) {
    for (const int bits : kBits) {
      const bool taken = offer_changed(q, offer, [&](Query& next) {
        std::size_t at = 0;
        for_each_number(next, [&](double& x) { x = at++ == i ? with_bits(x, bits) : x; });
        is_there = i < at;
      });
      if (taken) break;
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
      const Vec3<double>&p = patch.positions[i],
            &v = patch.moves()[patch.moves().size() > 1 ? i : 0];
      different.insert({p[0], p[1], p[2], v[0], v[1], v[2]});
    }
    // The number of control points counts, too: fewer are simpler even where they coincide.
    s.different_points += 64 * patch.positions.size() + different.size();
    // Ends, weights and loops are more than velocities, which every method takes.
    s.different_points += patch.has_ends() ? 32 : 0;
    s.different_points += patch.weights.empty() ? 0 : 32;
    for (const auto& loop : patch.trim) s.different_points += 32 + loop.size();
    s.different_points += patch.faces.size() + (patch.one_sided ? 1 : 0);
    const auto count_exponent = [&](double x) {
      if (x != 0) s.exponents += static_cast<std::uint64_t>(std::abs(std::ilogb(x)));
    };
    for_each_coordinate(patch, count_exponent);
    std::ranges::for_each(patch.weights, count_exponent);
  }
  return s;
}

void offer_simpler(const Contact& current, const Offer& offer) {
  if (is_of_bodies(current.query)) {
    offer_simpler_bodies(current, offer);
    offer_rounded(current, offer);
  } else {
    offer_velocities(current, offer);
    offer_trims(current, offer);
    offer_weights(current, offer);
    offer_shapes(current, offer);
    offer_rounded(current, offer);
    offer_wholesale(current, offer);
    offer_times(current, offer);
    offer_units(current, offer);
    offer_point_by_point(current, offer);
  }
  offer_numbers(current, offer);
}

}  // namespace ccdfuzz
