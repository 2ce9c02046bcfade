#include <cmath>

#include "bezier/blossom.hpp"
#include "bezier/exact_patch.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/oracle/find_contact.hpp"

namespace ccdfuzz {

namespace {

/// The multiple of the largest power of two in [lo, hi]; lo ≤ hi, of magnitude ≤ 1.
Rational simplest_dyadic(double lo, double hi) {
  for (int bits = 0; bits < 60; ++bits) {
    const double m = std::ceil(std::ldexp(lo, bits));
    if (m <= std::ldexp(hi, bits)) return exact(std::ldexp(m, -bits));
  }
  return exact(lo);
}

/// The rational of the least denominator in [lo, hi], 0 ≤ lo ≤ hi (by continued fractions).
Rational simplest_rational(const Rational& lo, const Rational& hi, int steps = 40) {
  Integer floor;
  mpz_fdiv_q(floor.get_mpz_t(), lo.get_num_mpz_t(), lo.get_den_mpz_t());
  if (lo == Rational(floor) || steps == 0) return lo;
  if (Rational(floor + 1) <= hi) return Rational(floor + 1);
  const Rational rest = simplest_rational(Rational(1 / Rational(hi - floor)),
                                          Rational(1 / Rational(lo - floor)), steps - 1);
  return Rational(floor + 1 / rest);
}

Rational simplest(double x, double width, bool dyadic) {
  const double lo = std::clamp(x - width, 0.0, 1.0), hi = std::clamp(x + width, 0.0, 1.0);
  return dyadic ? simplest_dyadic(lo, hi) : simplest_rational(exact(lo), exact(hi));
}

/// Simple parameters near uv, inside the domain.
Uv<Rational> snapped(const Shape& shape, const Uv<double>& uv, double width, bool dyadic) {
  Uv<Rational> out{0, 0};
  const int parameters = shape.parameter_count();
  for (int k = 0; k < parameters; ++k) {
    out[static_cast<size_t>(k)] = simplest(uv[static_cast<size_t>(k)], width, dyadic);
  }
  if (shape.kind != ShapeKind::kTriangle) return out;
  // The two smaller barycentrics decide, so that an edge is met exactly.
  const double w = 1 - uv[0] - uv[1];
  if (w < uv[0] || w < uv[1]) {
    const Rational third = simplest(w, width, dyadic);
    const size_t larger = uv[0] > uv[1] ? 0 : 1;
    out[larger] = 1 - third - out[1 - larger];
  }
  return out;
}

/// The parameters of a trimmed patch's vertices, where they are near: of a vertex, or of an edge
/// along u or v.
void snap_to_trim(const Trim& trim, const Uv<double>& near, double width, Uv<Rational>& uv) {
  for (const auto& loop : trim) {
    for (const Uv<double>& vertex : loop) {
      for (const size_t k : {size_t{0}, size_t{1}}) {
        if (std::abs(vertex[k] - near[k]) <= width) uv[k] = exact(vertex[k]);
      }
    }
  }
}

/// A simple part of the way along the nearest edge of the loops, if that is near. The point is on
/// the edge exactly, whatever its slope.
void snap_to_edge(const Trim& trim, const Uv<double>& near, double width, bool dyadic,
                  Uv<Rational>& uv) {
  double least = width;
  for (const auto& loop : trim) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const Uv<double>&a = loop[i], &b = loop[(i + 1) % loop.size()];
      const double du = b[0] - a[0], dv = b[1] - a[1], length = std::hypot(du, dv);
      const double part = ((near[0] - a[0]) * du + (near[1] - a[1]) * dv) / (length * length);
      if (!(part >= 0 && part <= 1)) continue;
      const double distance = std::hypot(a[0] + part * du - near[0], a[1] + part * dv - near[1]);
      if (!(distance <= least)) continue;
      least = distance;
      const Rational share = simplest(part, width / length, dyadic);
      for (const size_t k : {size_t{0}, size_t{1}}) {
        uv[k] = exact(a[k]) + share * (exact(b[k]) - exact(a[k]));
      }
    }
  }
}

/// About the earlier root of |p + t·v|² = d², not before it and hardly after; 0 if they are that
/// near at 0. nullopt if they come no nearer.
std::optional<Rational> time_of_distance(const std::array<Vec3<Rational>, 2>& offset, double d) {
  Rational a = 0, b = 0, c = -exact(d) * exact(d);
  for (int k = 0; k < 3; ++k) {
    a += offset[1][k] * offset[1][k];
    b += offset[0][k] * offset[1][k];
    c += offset[0][k] * offset[0][k];
  }
  if (c <= 0) return Rational(0);
  const Rational discriminant = b * b - a * c;
  if (b >= 0 || discriminant < 0) return std::nullopt;
  // The root is c / (−b + √(b² − ac)): of a square root rounded down it is rounded up.
  const double ratio = round_down(discriminant / (b * b));
  const double root = std::max(0.0, std::sqrt(ratio) * (1 - 0x1p-50));
  return Rational(c / (-b * (1 + exact(root))));
}

/// The least t ≥ 0 at which the two points are in contact, if there is one; with a separation,
/// about that.
std::optional<Rational> meeting_time(const std::array<MovingPatch<Rational>, 2>& patches,
                                     double separation, const std::array<Uv<Rational>, 2>& uv) {
  const auto& [a, b] = patches;
  const auto difference = [&](const Points<Rational>& of_a, const Points<Rational>& of_b) {
    return Vec3<Rational>(evaluate<Rational>(a.shape, of_a, a.weights, uv[0]) -
                          evaluate<Rational>(b.shape, of_b, b.weights, uv[1]));
  };
  const std::array offset = {difference(a.positions, b.positions),
                             difference(a.velocities, b.velocities)};
  if (separation > 0) return time_of_distance(offset, separation);
  for (int k = 0; k < 3; ++k) {
    if (offset[1][k] != 0) return Rational(-offset[0][k] / offset[1][k]);
  }
  return Rational(0);
}

}  // namespace

std::optional<Witness> find_witness(const Query& query, const ContactGuess& guess) {
  const std::array patches = {exact_patch<Rational>(query.patches[0]),
                              exact_patch<Rational>(query.patches[1])};
  std::vector<std::array<Uv<Rational>, 2>> tried;
  for (const double factor : {1.0, 4.0, 32.0, 0x1p10, 0x1p16}) {
    const double width = guess.width * factor;
    if (width > 0x1p-5) break;
    enum class Way { kDyadic, kRational, kTrim, kDyadicOfEdge, kRationalOfEdge };
    for (const Way way :
         {Way::kDyadic, Way::kRational, Way::kTrim, Way::kDyadicOfEdge, Way::kRationalOfEdge}) {
      const bool dyadic = way != Way::kRational && way != Way::kRationalOfEdge;
      std::array<Uv<Rational>, 2> uv;
      bool inside = true;
      for (size_t s = 0; s < 2; ++s) {
        const Shape& shape = query.patches[s].shape;
        const Trim& trim = query.patches[s].trim;
        uv[s] = snapped(shape, guess.uv[s], width, dyadic);
        if (way == Way::kTrim) snap_to_trim(trim, guess.uv[s], width, uv[s]);
        if (way > Way::kTrim) snap_to_edge(trim, guess.uv[s], width, dyadic, uv[s]);
        inside = inside && shape.contains(uv[s]);
      }
      if (!inside || std::find(tried.begin(), tried.end(), uv) != tried.end()) continue;
      tried.push_back(uv);
      const auto t = meeting_time(patches, query.separation, uv);
      if (!t || *t < 0) continue;
      Witness witness{*t, uv};
      if (check_witness(query, witness)) return witness;
    }
  }
  return std::nullopt;
}

}  // namespace ccdfuzz
