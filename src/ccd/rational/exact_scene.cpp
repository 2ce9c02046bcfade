#include "ccd/rational/exact_scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/double_parts.hpp"
#include "base/verify.hpp"
#include "bezier/blossom.hpp"

namespace ccdfuzz::exact_ccd {

namespace {

/// parts·2^-unit as an integer. Requires parts.exponent ≥ unit or parts = 0.
Integer integer_in(const DoubleParts& parts, int unit) {
  Integer x = static_cast<long>(parts.mantissa);
  if (x != 0) x <<= static_cast<mp_bitcnt_t>(parts.exponent - unit);
  return x;
}

/// The words of a product and a sum. Measured, calling GMP takes as long as 6 operations on words.
std::uint64_t words_of(const Integer& x) {
  constexpr std::uint64_t kCalls = 6;
  return kCalls + mpz_size(x.get_mpz_t());
}

}  // namespace

void ExactScene::load(const Query& query, const Units& units) {
  units_ = units;
  separation_ = integer_in(parts_of(query.separation), units.length);
  for (size_t side = 0; side < 2; ++side) {
    const MovingPatch<double>& patch = query.patches[side];
    Side& s = sides_[side];
    s.shape = patch.shape;
    const size_t count = patch.positions.size();
    s.controls.resize(count);
    for (Part& part : s.parts) {
      part.cell.depth = kNoDepth;
      if (part.points.size() < count) part.points.resize(count);
    }
    if (net_.size() < count) net_.resize(count);
    for (size_t i = 0; i < count; ++i) {
      Control& control = s.controls[i];
      control[kWeight] = 1;
      for (size_t k = 0; k < 3; ++k) {
        const DoubleParts position = parts_of(patch.positions[i][static_cast<int>(k)]);
        control[k] = integer_in(position, units.length);
        const int unit = units.length - units.time;
        control[k + 3] = integer_in(parts_of(patch.moves()[i][static_cast<int>(k)]), unit);
        if (patch.has_ends()) control[k + 3] -= integer_in(position, unit);
      }
    }
    if (patch.is_rational()) multiply(s, patch.weights);
  }
}

/// The control points of a rational patch, homogeneous: of weights, a multiple that is whole.
void ExactScene::multiply(Side& s, const std::vector<double>& weights) {
  int unit = parts_of(weights[0]).exponent;
  for (const double w : weights) unit = std::min(unit, parts_of(w).exponent);
  for (size_t i = 0; i < weights.size(); ++i) {
    const Integer weight = integer_in(parts_of(weights[i]), unit);
    for (Integer& x : s.controls[i]) x *= weight;
  }
}

int ExactScene::gap_sign(int below, const std::array<Cell, 2>& cells, const IntegerAxis& axis,
                         double t, const std::array<std::span<const std::uint8_t>, 2>& candidates) {
  const auto lower = static_cast<size_t>(below), upper = 1 - lower;
  const Height& max = extreme(lower, true, cells[lower], axis, t, candidates[lower]);
  const Height& min = extreme(upper, false, cells[upper], axis, t, candidates[upper]);
  const Integer h = product(max.value, *min.weight) - product(min.value, *max.weight);
  if (separation_ == 0) return sgn(h);
  if (h >= 0) return 1;
  // h + d·|l|_2 with h < 0 has the sign of d²·|l|² − h².
  const Integer d = product(separation_, product(*min.weight, *max.weight));
  long norm_squared = 0;
  for (const std::int64_t x : axis.l) norm_squared += x * x;
  return sgn(Integer(product(d, d) * norm_squared - product(h, h)));
}

/// x·y.
Integer ExactScene::product(const Integer& x, const Integer& y) {
  work_ += words_of(x) * std::max<std::uint64_t>(1, mpz_size(y.get_mpz_t()));
  return x * y;
}

/// out = x·y.
void ExactScene::set_product(Integer& out, const Integer& x, std::int64_t y) {
  work_ += words_of(x);
  mpz_mul_si(out.get_mpz_t(), x.get_mpz_t(), y);
}

/// sum += x·y.
void ExactScene::add_product(Integer& sum, const Integer& x, std::int64_t y) {
  work_ += words_of(x);
  const auto size = static_cast<unsigned long>(y < 0 ? -y : y);
  (y < 0 ? mpz_submul_ui : mpz_addmul_ui)(sum.get_mpz_t(), x.get_mpz_t(), size);
}

bool ExactScene::is_beyond(const Height& a, const Height& b, bool above) {
  if (*a.weight == *b.weight) return above ? a.value > b.value : a.value < b.value;
  const Integer left = product(a.value, *b.weight), right = product(b.value, *a.weight);
  return above ? left > right : left < right;
}

ExactScene::Part& ExactScene::part_of(Side& side, const Cell& cell) {
  for (Part& part : side.parts) {
    if (part.cell == cell) return part;
  }
  Part& part = side.parts[side.oldest];
  side.oldest = (side.oldest + 1) % side.parts.size();
  part.cell = cell;
  part.made.fill(false);
  const std::array<Uv<double>, 3> at = cell.corners(side.shape);
  for (size_t c = 0; c < 3; ++c) {
    for (size_t k = 0; k < 2; ++k) {
      part.corners[c][k] = static_cast<std::int64_t>(std::ldexp(at[c][k], cell.depth));
    }
  }
  return part;
}

const ExactScene::Control& ExactScene::point(const Side& side, Part& part, int i, int j) {
  const auto at = static_cast<size_t>(side.shape.index(i, j));
  Control& out = part.points[at];
  if (part.made[at]) return out;
  part.made[at] = true;
  for (size_t k = 0; k < out.size(); ++k) out[k] = number(side, k, part, i, j);
  return out;
}

const ExactScene::Height& ExactScene::extreme(size_t which, bool maximum, const Cell& cell,
                                              const IntegerAxis& axis, double t,
                                              std::span<const std::uint8_t> candidates) {
  const DoubleParts parts = parts_of(t);
  CCDFUZZ_ASSERT(parts.mantissa == 0 || parts.exponent >= units_.time);
  const std::int64_t time =
      parts.mantissa == 0 ? 0 : parts.mantissa << (parts.exponent - units_.time);
  Side& side = sides_[which];
  Part& part = part_of(side, cell);
  Height& best = extremes_[which];
  best.weight = nullptr;
  const Shape& shape = side.shape;
  for_each_control(shape, [&](int i, int j) {
    if (candidates[static_cast<size_t>(shape.index(i, j))] == 0) return;
    const Control& p = point(side, part, i, j);
    height_.weight = &p[kWeight];
    set_product(height_.value, p[3], axis.l[0]);
    for (size_t k = 1; k < 3; ++k) add_product(height_.value, p[k + 3], axis.l[k]);
    set_product(height_.value, height_.value, time);
    for (size_t k = 0; k < 3; ++k) add_product(height_.value, p[k], axis.l[k]);
    if (best.weight == nullptr || is_beyond(height_, best, maximum)) std::swap(best, height_);
  });
  CCDFUZZ_ASSERT(best.weight != nullptr);
  return best;
}

/// Number k of control point (i, j) of the cell. It is the patch's blossom at i corners of the u
/// end, j of the v end and the origin for the rest. The parameters are homogeneous: weights of
/// sum 2^depth.
const Integer& ExactScene::number(const Side& side, size_t k, const Part& part, int i, int j) {
  const std::array<IntegerUv, 3>& corners = part.corners;
  const std::int64_t one = std::int64_t{1} << part.cell.depth;
  for (size_t a = 0; a < side.controls.size(); ++a) net_[a] = side.controls[a][k];
  blossom_in_place<Integer>(
      side.shape, net_,
      [&](const Integer& p, const Integer& q, int step, bool in_v) -> Integer&& {
        const std::int64_t s = corners[step < (in_v ? j : i) ? 1 : 0][in_v ? 1 : 0];
        set_product(sum_, p, one - s);
        add_product(sum_, q, s);
        return std::move(sum_);
      },
      [&](const Integer& pw, const Integer& pu, const Integer& pv, int step) -> Integer&& {
        const auto [u, v] = corners[static_cast<size_t>(corner_of_triangle(i, j, step))];
        set_product(sum_, pw, one - u - v);
        add_product(sum_, pv, v);
        add_product(sum_, pu, u);
        return std::move(sum_);
      });
  return net_[0];
}

}  // namespace ccdfuzz::exact_ccd
