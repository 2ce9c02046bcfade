#include "properties/pair_windows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "ccd/certified/pair_split.hpp"
#include "properties/draw_contact.hpp"
#include "query/case_json.hpp"

namespace ccdfuzz {

namespace {

using certified::PairSplit;

/// Follows one pair of cells through its axes.
class Follower final : public ExclusionObserver {
 public:
  explicit Follower(const Window& window) : left_(window) {}

  void excluded(const Exclusion& exclusion) override {
    const Separation<double>& times = exclusion.times;
    if (times.has_lo && times.has_hi) return;  // the pair is gone
    if (times.has_lo) left_.lo = std::max(left_.lo, times.hi);
    if (times.has_hi) left_.hi = std::min(left_.hi, times.lo);
  }

  void compared(const AxisGap& gap) override {
    const bool is_own = gap.axis >= kFirstOwnAxis;
    const int batch = (gap.axis - kFirstOwnAxis) / certified::kLanes;
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
  /// The first axis that was tried elsewhere than in what was left; empty if none was.
  const std::string& wrong() const { return wrong_; }

 private:
  /// Those before it, all pairs of the children share (PairSplit::expand).
  static constexpr int kFirstOwnAxis = 6;

  Window left_;
  int batch_ = -1;
  std::string wrong_;
};

Check check_pair_windows(ChoiceSource& choices) {
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
    Follower follower(pair.window);
    std::optional<PairSplit::Kept> kept;
    split.expand(
        pair, [&](int side, int child) { return child == wanted[static_cast<std::size_t>(side)]; },
        follower, [&](const PairSplit::Kept& one) { kept = one; });
    std::string wrong = follower.wrong();
    const Window& left = follower.left();
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

std::vector<Property> pair_window_properties() {
  return {
      {"tdibm-c.windows",
       "The axes of a pair of cells are tried in what those before left of its window, and what "
       "all of them leave is its window",
       "src/ccd/certified/pair_split.hpp", Expectation::kHolds, check_pair_windows},
  };
}

}  // namespace ccdfuzz
