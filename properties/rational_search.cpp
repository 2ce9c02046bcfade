#include <cmath>

#include "ccd/rational/pair_axes.hpp"
#include "ccd/rational/tdibm_rational.hpp"
#include "generators/draw_patch.hpp"
#include "properties/exact_gaps.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

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
    return exact_ccd::box_directions(patch.shape, {data.data(), patch.shape.control_count()}, t);
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
      {"tdibm-rational.is_what_it_says",
       "The method answers as its definition, written down naively",
       "src/ccd/rational/DERIVATION.md", check_naive_search},
  };
}

}  // namespace ccdfuzz
