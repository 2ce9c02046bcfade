#include "bezier/orientation.hpp"

#include <cstdint>
#include <optional>

#include "numeric/dyadic.hpp"

namespace ccdfuzz {

namespace {

/// x in units of 2^-62, if it is a multiple of these and |x| ≤ 1.
std::optional<std::int64_t> in_small_units(double x) {
  constexpr int kUnit = -62;
  const DoubleParts parts = parts_of(x);
  if (parts.mantissa == 0) return 0;
  if (parts.exponent < kUnit || compare(x, 1) > 0 || compare(x, -1) < 0) return std::nullopt;
  return parts.mantissa * (std::int64_t{1} << (parts.exponent - kUnit));
}

/// The sign of a·b − c·d.
template <class S>
int sign_of_difference(const S& a, const S& b, const S& c, const S& d) {
  const auto order = S(a * b) <=> S(c * d);
  return order < 0 ? -1 : order > 0 ? 1 : 0;
}

bool is_between(double x, double a, double b) {
  return (compare(a, x) <= 0 && compare(x, b) <= 0) || (compare(b, x) <= 0 && compare(x, a) <= 0);
}

}  // namespace

int orientation(const Uv<double>& a, const Uv<double>& b, const Uv<double>& c) {
  const auto au = in_small_units(a[0]), av = in_small_units(a[1]), bu = in_small_units(b[0]),
             bv = in_small_units(b[1]), cu = in_small_units(c[0]), cv = in_small_units(c[1]);
  if (au && av && bu && bv && cu && cv) {
    // Differences are at most 2^63 in magnitude, products 2^126.
    __extension__ using Wide = __int128;
    return sign_of_difference(Wide(*bu) - *au, Wide(*cv) - *av, Wide(*bv) - *av, Wide(*cu) - *au);
  }
  const auto way = [](double from, double to) { return Dyadic::exact(to) - Dyadic::exact(from); };
  return sign_of_difference(way(a[0], b[0]), way(a[1], c[1]), way(a[1], b[1]), way(a[0], c[0]));
}

bool is_on_segment(const Uv<double>& p, const Uv<double>& a, const Uv<double>& b) {
  return is_between(p[0], a[0], b[0]) && is_between(p[1], a[1], b[1]) && orientation(a, b, p) == 0;
}

bool crosses_ray(const Uv<double>& p, const Uv<double>& a, const Uv<double>& b) {
  const bool a_above = compare(a[1], p[1]) > 0, b_above = compare(b[1], p[1]) > 0;
  if (a_above == b_above) return false;
  if (compare(p[0], a[0]) < 0 && compare(p[0], b[0]) < 0) return true;
  if (compare(p[0], a[0]) > 0 && compare(p[0], b[0]) > 0) return false;
  return b_above ? orientation(a, b, p) > 0 : orientation(a, b, p) < 0;
}

}  // namespace ccdfuzz
