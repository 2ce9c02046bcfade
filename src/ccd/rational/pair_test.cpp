#include "ccd/rational/pair_test.hpp"

namespace ccdfuzz::exact_ccd {

namespace {

/// A part of the time step. Starts that differ by a few steps of the grid keep the deeper pair from
/// coming first: below 2^-22 this costs more pops than it saves.
constexpr double kFar = 0x1p-20;

}  // namespace

void PairTest::begin(const Query& query) {
  gap_.begin(query);
  is_apart_ = query.separation > 0;
  shapes_ = {query.patches[0].shape, query.patches[1].shape};
}

void PairTest::prepare(int side, std::span<const Cell> parts) {
  gap_.prepare(side, parts);
  axis_bits_ = is_apart_ ? kMostAxisBits : axis_bits(parts[0].depth);
  for (auto& frame : frames_[static_cast<size_t>(side)]) frame.reset();
}

const BoxDirections& PairTest::frame(int side, int part, double t) {
  const auto s = static_cast<size_t>(side);
  std::optional<BoxDirections>& frame = frames_[s][static_cast<size_t>(part)];
  if (!frame) frame = box_directions(shapes_[s], gap_.points(side, part), t);
  return *frame;
}

void PairTest::tell(ExclusionObserver& observer, int axis, const IntegerAxis& direction,
                    const Window& before, bool is_left, const Window& after) const {
  const auto exclude = [&](double lo, double hi, bool has_lo, bool has_hi) {
    // The lower side is the one with the lesser gap at the excluded end. The gaps of the two sides
    // add up to the widths of both cells on the axis, so they are not both negative.
    const Extremes at_end = gap_.extremes(has_lo ? lo : hi);
    observer.excluded({axis,
                       Vec3<double>(direction.l[0], direction.l[1], direction.l[2]),
                       at_end.gap(0) < at_end.gap(1) ? 0 : 1,
                       {gap_.unscaled(lo), gap_.unscaled(hi), has_lo, has_hi}});
  };
  if (before.lo < after.lo) exclude(before.lo, after.lo, true, false);
  if (after.hi < before.hi) exclude(after.hi, before.hi, false, true);
  if (!is_left) exclude(after.lo, after.hi, true, true);
}

std::optional<Window> PairTest::test(int part_a, int part_b, const Window& window,
                                     ExclusionObserver* observer) {
  Window w{gap_.scaled(window.lo), gap_.scaled(window.hi)};
  gap_.select(part_a, part_b);
  apart_.reset();
  const int axes = is_apart_ ? certified::CandidateAxes::kMost : kPairAxes;
  // Cycle through the axes until all in a row leave the window unchanged: an axis may separate at
  // an end that another has uncovered. The bound on the rounds only saves time: a longer window is
  // safe.
  constexpr int kMaxRounds = 4;
  int unchanged = 0;
  for (int n = 0; n < kMaxRounds * axes && unchanged < axes; ++n) {
    const int r = n % axes;
    // A round begins where those before it have moved the start: with other axes, all of which are
    // tried if it is far.
    if (is_apart_ && r == 0 && !(apart_ && apart_time_ == w.lo)) {
      if (apart_ && w.lo - apart_time_ >= kFar) unchanged = 0;
      apart_.emplace(axes_apart(shapes_, gap_.points(0, part_a), gap_.points(1, part_b), w.lo));
      apart_time_ = w.lo;
    }
    ++unchanged;
    const Vec3<double> direction =
        is_apart_ ? Vec3<double>((*apart_)[r].data())
                  : pair_axis(frame(0, part_a, w.lo), frame(1, part_b, w.lo), r);
    const std::optional<IntegerAxis> axis = round_to_axis(direction, axis_bits_);
    if (!axis) continue;
    gap_.project(*axis);
    const Window before = w;
    const bool is_left = cut_window(gap_, w);
    if (observer != nullptr) tell(*observer, r, *axis, before, is_left, w);
    if (!is_left) return std::nullopt;
    // This axis has just been tried on the new window.
    if (w.lo != before.lo || w.hi != before.hi) unchanged = 1;
  }
  return Window{gap_.unscaled(w.lo), gap_.unscaled(w.hi)};
}

}  // namespace ccdfuzz::exact_ccd
