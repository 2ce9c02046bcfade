#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "case/case_json.hpp"
#include "ccd/certified/pair_split.hpp"
#include "generators/draw_contact.hpp"
#include "properties/error_bound.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

using certified::PairSplit;

/// Follows one pair of cells through its axes.
class Follower final : public ExclusionObserver {
 public:
  /// depth: of the pair.
  Follower(const certified::NormalisedQuery& query, int depth, const Window& window)
      : query_(query), left_(window) {
    for (const Shape& shape : query.shapes) {
      roundings_ = std::max(roundings_, (shape.n + shape.m) * depth);
    }
  }

  void excluded(const Exclusion& exclusion) override {
    const Separation<double>& times = exclusion.times;
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

  void compared(const AxisGap& gap) override {
    check_error(gap);
    const bool is_own = gap.axis >= PairSplit::kFirstOwnAxis;
    const int batch = (gap.axis - PairSplit::kFirstOwnAxis) / certified::kLanes;
    if (!is_own || batch == batch_) return;
    batch_ = batch;
    if (gap.window.lo == left_.lo && gap.window.hi == left_.hi) return;
    if (wrong_.empty()) {
      wrong_ = fmt::format("axis {} is tried in [{}, {}], and [{}, {}] is left", gap.axis,
                           to_hex(gap.window.lo), to_hex(gap.window.hi), to_hex(left_.lo),
                           to_hex(left_.hi));
    }
  }

  const Window& left() const { return left_; }
  /// Whether the axes took all of the window.
  bool is_gone() const { return gone_; }
  /// The first axis that was tried with too small a bound, or elsewhere than in what was left;
  /// empty if none was.
  const std::string& wrong() const { return wrong_; }

 private:
  /// The bound is that of the axis and of the pair's depth.
  void check_error(const AxisGap& gap) {
    if (std::isinf(gap.unit)) return;
    Dyadic norm;
    for (int k = 0; k < 3; ++k) norm += abs(Dyadic::exact(gap.direction[k]));
    const Dyadic least = derived_error(query_.magnitude, query_.absolute, roundings_, norm);
    if (least <= Dyadic::exact(gap.unit) || !wrong_.empty()) return;
    wrong_ = fmt::format("axis {} {} {} has the bound {}", to_hex(gap.direction[0]),
                         to_hex(gap.direction[1]), to_hex(gap.direction[2]), to_hex(gap.unit));
  }

  const certified::NormalisedQuery& query_;
  int roundings_ = 0;
  bool gone_ = false;
  Window left_;
  int batch_ = -1;
  std::string wrong_;
};

Check check_pair_windows(Draw& choices) {
  constexpr int kLevels = 4;
  const Result<Case> drawn = draw_contact(choices, ContactRange());
  if (!drawn) return Check::discarded(drawn.error().message());
  PairSplit split;
  split.begin(drawn->query, kLevels);
  struct {
    Window window;
    certified::Axis hint{1, 0, 0};
    std::array<PairSplit::Node, 2> cells{};
    int depth = 0;
  } pair;
  pair.window = {0, split.query().t_max};
  for (; pair.depth < kLevels; ++pair.depth) {
    std::array<int, 2> wanted{};
    for (std::size_t s = 0; s < 2; ++s) {
      const int children = drawn->query.patches[s].shape.child_count();
      wanted[s] = static_cast<int>(choices.choose(static_cast<std::uint64_t>(children - 1)));
    }
    Follower follower(split.query(), pair.depth + 1, pair.window);
    std::optional<PairSplit::Kept> kept;
    split.expand(
        pair, [&](int side, int child) { return child == wanted[static_cast<std::size_t>(side)]; },
        follower, [&](const PairSplit::Kept& one) { kept = one; });
    std::string wrong = follower.wrong();
    const Window& left = follower.left();
    if (!kept && wrong.empty() && !follower.is_gone()) {
      wrong = fmt::format("dropped, and [{}, {}] is left", to_hex(left.lo), to_hex(left.hi));
    }
    if (kept && wrong.empty() && (kept->window.lo != left.lo || kept->window.hi != left.hi)) {
      wrong = fmt::format("[{}, {}] is kept, and [{}, {}] is left", to_hex(kept->window.lo),
                          to_hex(kept->window.hi), to_hex(left.lo), to_hex(left.hi));
    }
    if (!wrong.empty()) {
      return Check::fails(fmt::format("children {} and {} at depth {}: {}\n{}", wanted[0],
                                      wanted[1], pair.depth, wrong, to_json(*drawn)));
    }
    if (!kept) break;
    pair.window = kept->window;
    pair.hint = kept->hint;
    pair.cells = kept->cells;
  }
  return Check::holds();
}

}  // namespace

std::vector<Property> pair_windows_claims() {
  return {
      {"tdibm-c.windows",
       "The axes of a pair of cells are tried in what those before left of its window, with the E "
       "of its depth; what all of them leave is its window, and it is dropped where that is "
       "nothing",
       "src/ccd/certified/DERIVATION.md, 3", Expectation::kHolds, check_pair_windows},
  };
}

}  // namespace ccdfuzz
