#pragma once

#include <bit>
#include <cmath>

#include "bezier/random_patch.hpp"
#include "case/case.hpp"

namespace ccdfuzz {

/// Any finite double: every bit pattern, and often the ends of the range, ±0 and small integers.
inline double any_finite_double() {
  const auto bits = *rc::gen::oneOf(
      rc::gen::arbitrary<std::uint64_t>(),
      rc::gen::element<std::uint64_t>(0, std::uint64_t{1} << 63, 1, 0x000fffffffffffff,
                                      0x0010000000000000, 0x7fefffffffffffff, 0xffefffffffffffff,
                                      std::bit_cast<std::uint64_t>(0x1p53),
                                      std::bit_cast<std::uint64_t>(0x1p64)),
      rc::gen::map(rc::gen::inRange(-1000, 1000),
                   [](int i) { return std::bit_cast<std::uint64_t>(double{1} * i); }));
  const auto x = std::bit_cast<double>(bits);
  return std::isfinite(x) ? x : 0.1;
}

inline Rational any_rational() {
  const long p = *rc::gen::arbitrary<std::int32_t>();
  const long q = *rc::gen::inRange<std::int32_t>(1, 1 << 30);
  Rational r{Integer(p), Integer(q)};
  r.canonicalize();
  return r;
}

inline std::string any_text() {
  return *rc::gen::container<std::string>(
      rc::gen::element('a', 'Z', '0', '"', '\\', '\n', '\x01', '/', ' ', ':', '.', '-'));
}

inline Query any_query(bool may_be_of_bodies = false) {
  Query query;
  const bool of_bodies = may_be_of_bodies && *rc::gen::inRange(0, 4) == 0;
  for (MovingPatch<double>& patch : query.patches) {
    patch.shape =
        of_bodies ? Shape::hull(*rc::gen::inRange(1, kMaxControls + 1)) : *any_shape(kMaxDegree);
    if (of_bodies) patch.radius = std::abs(any_finite_double());
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      const bool is_one = of_bodies && points == &patch.velocities;
      points->resize(is_one ? 1 : static_cast<size_t>(patch.shape.control_count()));
      for (Vec3<double>& p : *points) {
        for (int k = 0; k < 3; ++k) p[k] = any_finite_double();
      }
    }
  }
  query.t_max = std::abs(any_finite_double());
  return query;
}

/// A case that says anything a file may say; its truth is made up.
inline Case any_case() {
  const auto maybe = [] { return *rc::gen::arbitrary<bool>(); };
  Case c;
  c.query = any_query(true);
  if (maybe()) {
    c.truth.witness = Witness{any_rational(), {}};
    for (size_t s = 0; s < 2; ++s) {
      const auto count = static_cast<size_t>(c.query.patches[s].shape.control_count());
      if (is_of_bodies(c.query)) {
        c.truth.witness->weights[s].assign(count, any_rational());
      } else {
        c.truth.witness->uv[s] = {any_rational(), any_rational()};
      }
    }
  }
  if (maybe()) c.truth.clear_until = any_rational();
  if (maybe()) {
    ContactBox& box = c.truth.contact_box.emplace();
    for (double& x : box.centre) x = any_finite_double();
    box.dependent = {*rc::gen::inRange(0, 3), *rc::gen::inRange(0, 3)};
    box.varied = *rc::gen::element(std::array{0, 1, 2}, std::array{0, 3, 4}, std::array{2, 3, 4});
    for (double& x : box.radius) {
      x = std::abs(any_finite_double());
      if (x == 0) x = 1;
    }
    for (auto& row : box.inverse) {
      for (double& x : row) x = any_finite_double();
    }
  }
  if (maybe()) {
    c.truth.contact_root = ContactRoot{
        {any_rational().get_num(), any_rational().get_num()}, any_rational(), any_rational()};
  }
  if (maybe()) {
    if (maybe()) {
      c.truth.clearance = LinearClearance{any_rational(), maybe()};
    } else if (maybe()) {
      c.truth.clearance =
          BodyClearance{any_rational(), {any_rational(), any_rational(), any_rational()}, maybe()};
    } else if (maybe()) {
      c.truth.clearance = MovingPlane{
          any_rational(), {any_rational(), any_rational(), any_rational()}, any_rational()};
    } else {
      c.truth.clearance = MissTree{
          any_rational(),
          {*rc::gen::inRange<std::uint64_t>(0, 1 << 30),
           *rc::gen::inRange<std::uint64_t>(1, 1 << 30), "00112233445566778899aabbccddeeff"}};
    }
    if (maybe()) c.truth.proof = proof_word(*c.truth.clearance);
  }
  if (!c.truth.proof && maybe()) c.truth.proof = "rational-tdibm";
  if (maybe()) {
    const bool collides = maybe();
    if (collides ? c.truth.witness || c.truth.contact_box || c.truth.contact_root
                 : c.truth.proof.has_value()) {
      c.truth.collides = collides;
    }
  }
  for (std::string* text : {&c.origin.contact, &c.origin.kind, &c.origin.generator,
                            &c.origin.ccdfuzz, &c.origin.name, &c.origin.note}) {
    *text = any_text();
  }
  if (maybe()) c.origin.seed = *rc::gen::arbitrary<std::uint64_t>();
  if (maybe()) c.origin.index = *rc::gen::arbitrary<std::uint64_t>();
  if (maybe()) c.origin.more["precision"] = "1e-2";
  if (maybe()) c.asked.precision = 0.01;
  if (maybe()) c.asked.max_pops = *rc::gen::inRange<std::uint64_t>(1, 9);
  if (maybe()) c.origin.more["family"] = "\"fl\\u00e4t\"";
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
    const std::vector<Outcome> outcomes(kAllOutcomes.begin(), kAllOutcomes.end());
    c.expect[any_text()] = {*rc::gen::elementOf(outcomes), maybe() ? any_text() : ""};
  }
  return c;
}

/// True iff every number of both is the same bit pattern.
inline bool same_bits(const Query& a, const Query& b) {
  const auto same = [](const Points<double>& p, const Points<double>& q) {
    if (p.size() != q.size()) return false;
    for (size_t i = 0; i < p.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        if (std::bit_cast<std::uint64_t>(p[i][k]) != std::bit_cast<std::uint64_t>(q[i][k])) {
          return false;
        }
      }
    }
    return true;
  };
  for (size_t s = 0; s < 2; ++s) {
    if (a.patches[s].shape != b.patches[s].shape) return false;
    if (!same(a.patches[s].positions, b.patches[s].positions)) return false;
    if (!same(a.patches[s].velocities, b.patches[s].velocities)) return false;
  }
  return std::bit_cast<std::uint64_t>(a.t_max) == std::bit_cast<std::uint64_t>(b.t_max);
}

}  // namespace ccdfuzz
