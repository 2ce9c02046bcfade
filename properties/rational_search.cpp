#include <cmath>

#include "base/double_parts.hpp"
#include "ccd/rational/exact_scene.hpp"
#include "ccd/rational/pair_axes.hpp"
#include "ccd/rational/tdibm_rational.hpp"
#include "generators/draw_patch.hpp"
#include "properties/exact_gaps.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

using exact_ccd::IntegerAxis;
using exact_ccd::Units;

constexpr int kLimitAxisBits = 30;

/// Coordinates that are all ±(2^bits − 1), except one that is 1.
Points<double> draw_largest_points(Draw& d, const Shape& shape, int bits, bool positive) {
  const double largest = std::ldexp(1.0, bits) - 1;
  Points<double> points(static_cast<std::size_t>(shape.control_count()),
                        {largest, largest, largest});
  for (Vec3<double>& p : points) {
    for (double& x : p) {
      if (!positive || d.choose(15) == 15) x = -largest;
    }
  }
  points[0][0] = 1;
  return points;
}

/// A query whose predicates need as many bits as possible at cells of the depth, but ≤ `bits`.
Query draw_query_at_limit(Draw& d, int bits, int depth) {
  Query query;
  const int max_degree = std::min(bits / 64, kMaxDegree);
  const int drift = d.integer(0, 9);
  const int mantissa = d.integer(1, bits < 256 ? 9 : 53);
  query.t_max = bits < 256 ? 0x1.fffp-500 : d.pick(std::array{1.0, 0x1.fffffffffffffp60});
  const bool below = d.coin();
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& moving = query.patches[s];
    moving.shape = draw_shape(d, max_degree);
    moving.positions = draw_largest_points(d, moving.shape, mantissa, below == (s == 0));
    moving.velocities = draw_largest_points(d, moving.shape, mantissa, below == (s == 0));
    for (Vec3<double>& v : moving.velocities) {
      for (double& x : v) x = std::ldexp(x, -drift - parts_of(query.t_max).top());
    }
  }
  // The lowest bit is that of the velocities times the unit of time. Raising the positions above it
  // a bit at a time reaches every number of bits.
  const auto fits = [&](const Query& asked) {
    return Units::of(asked).bits_needed(kLimitAxisBits, depth) <= bits;
  };
  suppose(fits(query));
  for (Query raised = query; fits(raised);) {
    query = raised;
    for (MovingPatch<double>& moving : raised.patches) {
      for (Vec3<double>& p : moving.positions) p *= 2;
    }
  }
  return query;
}

template <int Bits>
void check_last_bit(Draw& d) {
  const int depth = d.integer(0, Bits < 256 ? 5 : 10);
  const Query query = show(d, "query", draw_query_at_limit(d, Bits, depth));
  const auto& [a, b] = query.patches;
  const Cell first = draw_cell_at(d, a.shape, depth), second = draw_cell_at(d, b.shape, depth);
  constexpr std::int32_t kMost = std::int32_t{1} << kLimitAxisBits;
  IntegerAxis axis{{kMost, kMost, kMost}};
  for (std::int32_t& x : axis.l) {
    if (d.choose(7) == 7) x = d.pick(std::array{-kMost, 0, 1, kMost - 1});
  }
  const double t = show(d, "t", d.pick(std::array{query.t_max, 0.0}));
  show(d, "bits", Units::of(query).bits_needed(kLimitAxisBits, depth));
  show(d, "cells", std::array{first, second});
  show(d, "axis", axis.l);
  exact_ccd::ExactScene<WideInt<Bits>> scene;
  scene.load(query, Units::of(query));
  const std::vector<std::uint8_t> all(kMaxControls, 1);
  const std::array lines = {lines_of_cell(a, first, axis), lines_of_cell(b, second, axis)};
  for (std::size_t below = 0; below < 2; ++below) {
    const int sign = scene.gap_sign(static_cast<int>(below), {first, second}, axis, t, {all, all});
    CLAIM(sign == sgn(exact_gap(lines[below], lines[1 - below], exact(t))));
  }
}

/// The inclusion test written down naively: exact sub-patches, exact windows from all pairs of
/// lines, no filter, no integers, no grid.
class NaiveTest {
 public:
  void begin(const Query& query) { query_ = query; }
  void prepare(int side, std::span<const Cell> parts) {
    std::copy(parts.begin(), parts.end(), parts_[static_cast<std::size_t>(side)].begin());
  }

  std::optional<Window> test(int part_a, int part_b, const Window& window) {
    const std::array<Cell, 2> cells = {parts_[0][static_cast<std::size_t>(part_a)],
                                       parts_[1][static_cast<std::size_t>(part_b)]};
    std::array<exact_ccd::BoxDirections, 2> frames;
    for (std::size_t s = 0; s < 2; ++s) frames[s] = frame(query_.patches[s], cells[s], window.lo);
    // Per axis and sign, the lines whose maximum must stay below the other lines' minimum.
    std::vector<std::array<RationalLines, 2>> constraints;
    for (int r = 0; r < exact_ccd::kPairAxes; ++r) {
      const auto axis = exact_ccd::round_to_axis(exact_ccd::pair_axis(frames[0], frames[1], r),
                                                 exact_ccd::axis_bits(cells[0].depth));
      if (!axis) continue;
      const RationalLines a = lines_of_cell(query_.patches[0], cells[0], *axis);
      const RationalLines b = lines_of_cell(query_.patches[1], cells[1], *axis);
      constraints.push_back({a, b});
      constraints.push_back({b, a});
    }
    Rational lo = exact(window.lo), hi = exact(window.hi);
    for (bool moved = true; moved;) {
      moved = false;
      for (const auto& [lower, upper] : constraints) {
        const auto s = separated_times(lower, upper, lo, hi);
        if (!s) continue;
        if (s->contains(lo) && s->contains(hi)) return std::nullopt;
        if (s->contains(lo)) lo = s->to, moved = true;
        if (s->contains(hi)) hi = s->from, moved = true;
      }
    }
    return Window{round_down(lo), round_up(hi)};
  }

 private:
  static exact_ccd::BoxDirections frame(const MovingPatch<double>& patch, const Cell& cell,
                                        double t) {
    const MovingPatch<Dyadic> part =
        restrict_to(exact_patch<Dyadic>(patch), exact_corners<Dyadic>(cell.corners(patch.shape)));
    std::vector<double> data;
    for (const Points<Dyadic>* points : {&part.positions, &part.velocities}) {
      for (int k = 0; k < 3; ++k) {
        for (const Vec3<Dyadic>& p : *points) data.push_back(p[k].rational().get_d());
      }
    }
    const int count = patch.shape.control_count();
    return exact_ccd::box_directions(patch.shape, {data.data(), count, count}, t);
  }

  Query query_;
  std::array<std::array<Cell, 4>, 2> parts_;
};

void check_naive_search(Draw& d) {
  // Rounded windows start the next level a little earlier. Axes made at another time, however near,
  // may differ in the last of their 16 bits.
  constexpr double kAxisRounding = 0x1p-14;
  const bool fine = d.coin();
  Query query = draw_query(d, 2, [fine](Draw& choices) {
    return *choices.lattice(fine ? 12 : 1, fine ? -6 : 0).to_double_exactly();
  });
  query.t_max = d.pick(std::array{0.0, 1.0, 0.1, 2.0});
  const double apart = d.integer(0, 4);
  for (Vec3<double>& p : query.patches[1].positions) p[0] += apart;
  const SearchOptions options{.precision = 0x1p-3, .max_pops = 10};
  show(d, "query", query);
  const Answer fast = TdibmRational().answer(query, options);
  const Answer slow = Search<NaiveTest>().answer(query, options);
  show(d, "toi", fast.toi);
  show(d, "naively", slow.toi);
  CLAIM(fast.verdict == slow.verdict);
  CLAIM(!slow.toi || std::abs(*fast.toi - *slow.toi) <= kAxisRounding);
}

}  // namespace

std::vector<Property> rational_search_claims() {
  return {
      {"tdibm-rational.last_bit",
       "Integers of the narrowest size that suffices give the exact sign of a gap",
       "src/ccd/rational/units.hpp",
       [](Draw& d) {
         constexpr std::array kSizes = {check_last_bit<128>, check_last_bit<256>,
                                        check_last_bit<512>};
         d.pick(kSizes)(d);
       }},
      {"tdibm-rational.is_what_it_says",
       "The method answers as its definition, written down naively",
       "src/ccd/rational/DERIVATION.md", check_naive_search},
  };
}

}  // namespace ccdfuzz
