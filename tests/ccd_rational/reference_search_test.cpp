// tdibm-rational against the same method written down naively: exact sub-patches, exact windows
// from all pairs of lines, no filter, no integers, no grid.
#include "bezier/exact_patch.hpp"
#include "ccd/rational/pair_axes.hpp"
#include "ccd/rational/tdibm_rational.hpp"
#include "ccd_rational/exact_reference.hpp"
#include "ccd_rational/random_query.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

/// Rounded windows start the next level a little earlier. Axes made at another time, however near,
/// may differ in the last of their 16 bits.
constexpr double kAxisRounding = 0x1p-14;

class ReferenceTest {
 public:
  void begin(const Query& query) { query_ = query; }
  void prepare(int side, std::span<const Cell> parts) {
    const auto s = static_cast<size_t>(side);
    std::copy(parts.begin(), parts.end(), parts_[s].begin());
  }

  std::optional<Window> test(int part_a, int part_b, const Window& window) {
    const std::array<Cell, 2> cells = {parts_[0][static_cast<size_t>(part_a)],
                                       parts_[1][static_cast<size_t>(part_b)]};
    std::array<exact_ccd::BoxDirections, 2> frames;
    for (size_t s = 0; s < 2; ++s) frames[s] = frame(query_.patches[s], cells[s], window.lo);
    // Per axis and sign, the lines whose maximum must stay below the other lines' minimum.
    std::vector<std::array<std::vector<ExactLine>, 2>> constraints;
    for (int r = 0; r < exact_ccd::kPairAxes; ++r) {
      const auto axis = exact_ccd::round_to_axis(exact_ccd::pair_axis(frames[0], frames[1], r),
                                                 exact_ccd::axis_bits(cells[0].depth));
      if (!axis) continue;
      const auto a = exact_lines(query_.patches[0], cells[0], *axis);
      const auto b = exact_lines(query_.patches[1], cells[1], *axis);
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

RC_GTEST_PROP(TdibmRational, AgreesWithTheMethodWrittenDownNaively, ()) {
  const RandomCoordinates coordinates{
      *rc::gen::element(RandomCoordinates::kLattice, RandomCoordinates::kDyadic)};
  Query query = any_query(kOneIn == 1 ? 2 : 1, coordinates);
  query.t_max = *rc::gen::element(0.0, 1.0, 0.1, 2.0);
  const double apart = *rc::gen::inRange(0, 5);  // nearer to a decision than two patches at once
  for (Vec3<double>& p : query.patches[1].positions) p[0] += apart;
  SearchOptions options;
  options.precision = 0x1p-3;
  options.max_pops = kOneIn == 1 ? 40 : 10;

  TdibmRational method;
  Search<ReferenceTest> search;
  ReferenceTest reference;
  const Answer fast = method.answer(query, options);
  const Answer slow = search.run(query, options, reference);
  RC_TAG(static_cast<int>(slow.verdict));
  RC_LOG() << to_text(query.patches[0].shape) << " " << to_text(query.patches[1].shape) << "\n";
  RC_ASSERT(fast.verdict == slow.verdict);
  if (slow.toi) {
    RC_LOG() << to_hex(*fast.toi) << " " << to_hex(*slow.toi) << "\n";
    RC_ASSERT(std::abs(*fast.toi - *slow.toi) <= kAxisRounding);
  }
}

}  // namespace
}  // namespace ccdfuzz
