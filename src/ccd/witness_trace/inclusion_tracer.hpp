#pragma once

#include "base/fp_guard.hpp"
#include "base/verify.hpp"
#include "ccd/witness_trace/frontier.hpp"
#include "ccd/witness_trace/watch.hpp"

namespace ccdfuzz {

/// Follows a witness through the inclusion test that a Search would run: the same splits, windows
/// and tests, of those pairs alone that contain the witness. One object serves one thread; it keeps
/// its buffers, so that tracing allocates nothing once it is warm, but for the witness's numbers.
template <class Inclusion>
class InclusionTracer {
 public:
  template <class... Args>
  explicit InclusionTracer(Args&&... args) : inclusion_(std::forward<Args>(args)...) {}

  /// Requires and errors: as Method::trace (method/method.hpp).
  const Trace& trace(const Query& query, const Witness& witness, const TraceOptions& options) {
    const FpGuard guard;
    CCDFUZZ_VERIFY(is_taken(query, {.precision = options.precision}) && sgn(witness.t) >= 0);
    const std::array<Shape, 2> shapes = {query.patches[0].shape, query.patches[1].shape};
    path_.assign(shapes, witness);
    CCDFUZZ_VERIFY(path_.time().hi <= query.t_max);
    watch_.begin(path_.time(), options.steps);
    const int target = depth_for(options.precision);

    inclusion_.begin(query);
    parts_.assign(query);
    parts_.prepare(inclusion_);
    now_.clear();
    for (auto* level : {&now_, &next_}) level->reserve(kMostOfLevel);
    test(0, 0, Window{0, query.t_max}, now_);
    for (int level = 0; level < target && !now_.empty(); ++level) {
      next_.clear();
      for (const Pair& pair : now_) {
        parts_.split(shapes, pair.cells);
        parts_.trim(pair.cells, pair.crossed);
        parts_.prepare(inclusion_);
        for (const Window& window : time_parts<Inclusion>(pair.window)) {
          if (!path_.time().within(window)) continue;
          for_each_choice(path_, parts_, options.all,
                          [&](int a, int b) { test(a, b, window, next_); });
          // Halves of a window of one time are the same.
          if (!options.all || pair.window.lo == pair.window.hi) break;
        }
      }
      std::swap(now_, next_);
    }
    return watch_.trace();
  }

 private:
  struct Pair {
    Window window;
    std::array<Cell, 2> cells;
    unsigned crossed;  ///< as Search has it
  };

  void test(int a, int b, const Window& window, std::vector<Pair>& kept) {
    const std::array<Cell, 2> cells = {parts_.cells[0][static_cast<size_t>(a)],
                                       parts_.cells[1][static_cast<size_t>(b)]};
    watch_.look_at({cells[0].depth, cells, window});
    std::optional<Window> left;
    if (parts_.counts(a, b)) left = inclusion_.test(a, b, window, &watch_);
    if (watch_.judge(left)) kept.push_back({*left, cells, parts_.crossed(a, b)});
  }

  Inclusion inclusion_;
  PairParts parts_;
  WitnessPath path_;
  WitnessWatch watch_;
  std::vector<Pair> now_, next_;
};

}  // namespace ccdfuzz
