#include <algorithm>
#include <cmath>

#include "ccd/certified/pair_split.hpp"
#include "generators/draw_contact.hpp"
#include "properties/draw_lines.hpp"
#include "properties/error_bound.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

using certified::PairSplit;

/// Follows one pair of cells through its axes. Claims that each is tried in the rest of the window,
/// and with at least the bound of the pair's depth.
class Follower final : public ExclusionObserver {
 public:
  /// depth: of the pair.
  Follower(Draw& d, const certified::NormalisedQuery& query, int depth, const Window& window)
      : d_(d), query_(query), left_(window) {
    for (const Shape& shape : query.shapes) {
      roundings_ = std::max(roundings_, (shape.n + shape.m) * depth);
    }
  }

  void excluded(const ExcludedInterval& exclusion) override {
    const SeparatedInterval<double>& times = exclusion.times;
    if (times.has_lo && times.has_hi) {
      gone_ = true;
      return;
    }
    if (times.has_lo) left_.lo = std::max(left_.lo, times.hi);
    if (times.has_hi) left_.hi = std::min(left_.hi, times.lo);
    // The new end of a trim by an own axis is separated itself: if it is all that is left, so is
    // that.
    const bool is_own = exclusion.axis >= PairSplit::kFirstOwnAxis;
    gone_ = gone_ || left_.lo > left_.hi || (is_own && left_.lo == left_.hi);
  }

  void compared(const SignedGap& gap) override {
    claim_bound(gap);
    const bool is_own = gap.axis >= PairSplit::kFirstOwnAxis;
    const int batch = (gap.axis - PairSplit::kFirstOwnAxis) / certified::kLanes;
    if (!is_own || batch == batch_) return;
    batch_ = batch;
    const bool is_in_what_is_left = gap.window.lo == left_.lo && gap.window.hi == left_.hi;
    if (!is_in_what_is_left) {
      show(d_, "axis", gap.axis);
      show(d_, "tried in", gap.window);
      show(d_, "left", left_);
    }
    CLAIM(is_in_what_is_left);
  }

  const Window& left() const { return left_; }
  /// Whether the axes took all of the window.
  bool is_gone() const { return gone_; }

 private:
  void claim_bound(const SignedGap& gap) {
    if (std::isinf(gap.in_units_of)) return;
    Dyadic norm;
    for (int k = 0; k < 3; ++k) norm += abs(Dyadic::exact(gap.direction[k]));
    const Dyadic derived = derived_error(query_.magnitude, query_.absolute, roundings_, norm);
    const bool is_bound = derived <= Dyadic::exact(gap.in_units_of);
    if (!is_bound) {
      show(d_, "direction", gap.direction);
      show(d_, "bound", gap.in_units_of);
    }
    CLAIM(is_bound);
  }

  Draw& d_;
  const certified::NormalisedQuery& query_;
  int roundings_ = 0;
  bool gone_ = false;
  Window left_;
  int batch_ = -1;
};

void check_pair_windows(Draw& d) {
  constexpr int kLevels = 4;
  const Case drawn = show(d, "contact", supposed(draw_contact(d, ContactRange())));
  PairSplit split;
  split.take(drawn.query);
  split.begin(kLevels);
  certified::CellPair pair{{0, split.query().t_max}, {1, 0, 0}, {}, {}};
  std::array<certified::CellPair, PairSplit::kMostPairs> kept;
  for (int depth = 0; depth < kLevels; ++depth) {
    std::array<int, 2> wanted{};
    for (std::size_t s = 0; s < 2; ++s) {
      const int children = drawn.query.patches[s].shape.child_count();
      wanted[s] = static_cast<int>(d.choose(static_cast<std::uint64_t>(children - 1)));
    }
    show(d, "children", wanted);
    Follower follower(d, split.query(), depth + 1, pair.window);
    const bool is_kept = split.split(pair, {1U << wanted[0], 1U << wanted[1]}, kept, &follower) > 0;
    const Window& left = follower.left();
    show(d, "left", left);
    CLAIM(is_kept || follower.is_gone());
    if (!is_kept) return;
    pair = kept[0];
    show(d, "kept", pair.window);
    CLAIM(pair.window.lo == left.lo);
    CLAIM(pair.window.hi == left.hi);
  }
}

}  // namespace

std::vector<Property> pair_windows_claims() {
  return {
      {"tdibm-c.windows",
       "The axes of a pair of cells are tried in what those before left of its window, with the E "
       "of its depth; what all of them leave is its window, and it is dropped where that is "
       "nothing",
       "src/ccd/certified/DERIVATION.md, 3", check_pair_windows},
  };
}

}  // namespace ccdfuzz
