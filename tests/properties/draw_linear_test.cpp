// What kinds of degenerate linear queries are drawn, and how many of each: exact for every query.
#include "properties/draw_linear.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "certify/linear/first_contact.hpp"
#include "numeric/effort.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

using linear::Polynomial;

/// In t, exact.
using PolyVector = std::array<Polynomial, 3>;

PolyVector minus(const PolyVector& a, const PolyVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
PolyVector cross(const PolyVector& a, const PolyVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool is_zero(const PolyVector& v) {
  return v[0].is_zero() && v[1].is_zero() && v[2].is_zero();
}

/// In units of the least double.
Integer in_least_doubles(double x) {
  return Rational(exact(x) * power_of_two(1074)).get_num();
}

std::vector<PolyVector> moving_points(const Query& query) {
  std::vector<PolyVector> points;
  for (const MovingPatch<double>& patch : query.patches) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      PolyVector& p = points.emplace_back();
      for (int k = 0; k < 3; ++k) {
        p[static_cast<size_t>(k)] = Polynomial(
            {in_least_doubles(patch.positions[i][k]), in_least_doubles(patch.velocities[i][k])});
      }
    }
  }
  return points;
}

bool is_at(linear::RealRoot& contact, double t) {
  const Rational at = exact(t);
  return contact.sign_of(Polynomial({-at.get_num(), at.get_den()})) == 0;
}

/// Whether one coordinate of one point, moved by one float, decides between contact and none.
bool hangs_on_one_float(const Query& query, bool touches) {
  for (size_t side = 0; side < 2; ++side) {
    for (size_t i = 0; i < query.patches[side].positions.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        for (const double towards : {-HUGE_VAL, HUGE_VAL}) {
          Query moved = query;
          double& x = moved.patches[side].positions[i][k];
          if (x != 0) x = std::nextafter(x, towards);
          if (linear::first_contact(moved).has_value() != touches) return true;
        }
      }
    }
  }
  return false;
}

TEST(DrawLinear, DrawsEveryKindOfDegenerateQuery) {
  const size_t count = 2000 / kOneIn * *effort();
  constexpr size_t kMovedOneIn = 50 / kOneIn + 1;  // moving every coordinate takes long
  std::map<std::string, size_t> drawn;
  size_t moved = 0;
  size_t queries = 0;
  for (size_t n = 0; n < count; ++n) {
    Draw choices = Draw::mostly_small(Random::keyed({1, n}));
    const Result<Query> query = draw_linear(choices);
    if (!query) continue;
    ++queries;
    const std::vector<PolyVector> p = moving_points(*query);
    const bool edges = query->patches[0].shape.kind == ShapeKind::kCurve &&
                       query->patches[1].shape.kind == ShapeKind::kCurve;
    const auto note = [&](const char* kind, bool is) { drawn[kind] += is ? 1 : 0; };
    if (p.size() == 4) {
      const PolyVector a = minus(p[1], p[0]);
      const PolyVector b = edges ? minus(p[3], p[2]) : minus(p[2], p[0]);
      const PolyVector c = minus(p[edges ? 2 : 3], p[0]);
      const PolyVector normal = cross(a, b);
      const Polynomial volume = normal[0] * c[0] + normal[1] * c[1] + normal[2] * c[2];
      note("coplanar motion", volume.is_zero());
      note("double root of coplanarity",
           !volume.is_zero() && squarefree(volume).degree() < volume.degree());
      if (edges) {
        const auto at_start = [](const PolyVector& v) {
          return v[0].sign_at(0) == 0 && v[1].sign_at(0) == 0 && v[2].sign_at(0) == 0;
        };
        const bool parallel = is_zero(normal) && !is_zero(a) && !is_zero(b);
        note("edges parallel at the start", at_start(normal) && !at_start(a) && !at_start(b));
        note("edges parallel at all times", parallel);
        note("edges on one line at all times", parallel && is_zero(cross(a, c)));
      }
    }
    bool still = true;
    for (const PolyVector& point : p) {
      for (size_t k = 0; k < 3; ++k) still = still && point[k].derivative() == p[0][k].derivative();
    }
    note("static", still);
    auto contact = linear::first_contact(*query);
    note("contact", contact.has_value());
    if (contact) {
      note("contact at t = 0", is_at(*contact, 0));
      note("contact at t = 1", is_at(*contact, 1));
      note("contact at t_max > 0", query->t_max > 0 && is_at(*contact, query->t_max));
    }
    if (n % kMovedOneIn == 0) {
      ++moved;
      note("touching within one float", hangs_on_one_float(*query, contact.has_value()));
    }
  }
  ASSERT_GT(queries, count / 2);
  for (const auto& [kind, of_it] : drawn) {
    const size_t among = kind == "touching within one float" ? moved : queries;
    RecordProperty(kind, fmt::format("{} of {}", of_it, among));
    EXPECT_GT(200 * of_it, among) << kind << ": only " << of_it << " of " << among;
  }
  EXPECT_EQ(drawn.size(), 11U);
}

}  // namespace
}  // namespace ccdfuzz
