#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>

#include "base/fp_guard.hpp"
#include "base/stopwatch.hpp"
#include "bezier/trim_region.hpp"
#include "case/answer.hpp"
#include "case/query.hpp"
#include "case/refusal.hpp"
#include "case/search_options.hpp"
#include "ccd/search_queue.hpp"
#include "ccd/time_interval.hpp"

namespace ccdfuzz {

/// The wall-time budget of one query. The clock is read after some work, counted in control points
/// of tested cells. Then reading costs below 1 %, and no 20 ms pass between two readings: where
/// tdibm-rational must be exact, it takes about 10 µs a control point.
class Deadline {
 public:
  static constexpr int kWorkBetweenLooks = 128;

  explicit Deadline(const SearchOptions& options)
      : seconds_(options.max_seconds),
        clock_(options.clock != nullptr ? options.clock : steady_seconds) {
    if (is_limited()) start_ = clock_();
  }

  /// True iff the time has passed. work: done since the last call.
  bool passed(int work) {
    if (!is_limited()) return false;
    work_ += work;
    if (work_ < kWorkBetweenLooks) return false;
    work_ = 0;
    return left() < 0;
  }

  /// Seconds that are left, negative if the time has passed. Reads the clock.
  double left() const {
    return is_limited() ? seconds_ - (clock_() - start_) : SearchOptions::kNoTimeLimit;
  }

 private:
  bool is_limited() const { return seconds_ < SearchOptions::kNoTimeLimit; }

  double seconds_;
  double (*clock_)();
  double start_ = 0;
  int work_ = 0;
};

/// Depth at which every cell is at most `precision` wide: the least d with 2^-d ≤ precision, and at
/// most kMaxDepth. Outside of (0, 1] it is kMaxDepth: cells that are too small cost time alone.
inline int depth_for(double precision) {
  if (!(0 < precision && precision <= 1)) return Cell::kMaxDepth;
  int exponent = 0;
  // precision = f·2^e with ½ ≤ f < 1, so 2^-d ≤ precision iff d ≥ 1 − e, for f = ½ as for f > ½.
  std::frexp(precision, &exponent);
  return std::clamp(1 - exponent, 0, Cell::kMaxDepth);
}

/// The parts that one split of a pair of cells makes, or both patches whole.
struct PairParts {
  std::array<std::array<Cell, 4>, 2> cells{};
  std::array<int, 2> count{};
  /// Where the patches' loops are.
  std::array<TrimRegion, 2> regions;
  /// Parts of crossed cells; of others none is outside, and none crossed.
  std::array<TrimRegion::Children, 2> in_domain{};

  /// The whole patches of a query. Keeps the memory.
  void assign(const Query& query) {
    count = {1, 1};
    for (size_t side = 0; side < 2; ++side) {
      cells[side][0] = {};
      regions[side].assign(query.patches[side]);
      in_domain[side] = {0, regions[side].is_whole() ? 0U : 1U};
    }
  }

  /// After split, of cells of which those of the sides in `crossed` are crossed.
  void trim(const std::array<Cell, 2>& parents, unsigned crossed) {
    for (size_t side = 0; side < 2; ++side) {
      in_domain[side] = (crossed >> side & 1) != 0 ? regions[side].children(parents[side])
                                                   : TrimRegion::Children{};
    }
  }
  /// False if one of two parts is outside of its patch's domain.
  bool counts(int a, int b) const {
    return ((in_domain[0].outside >> a | in_domain[1].outside >> b) & 1) == 0;
  }
  /// Bit s where a loop of patch s meets its part.
  unsigned crossed(int a, int b) const {
    return (in_domain[0].crossed >> a & 1) | (in_domain[1].crossed >> b & 1) << 1;
  }

  /// The children of each cell, in the order of their places.
  void split(const std::array<Shape, 2>& shapes, const std::array<Cell, 2>& parents) {
    for (size_t side = 0; side < 2; ++side) {
      count[side] = shapes[side].child_count();
      for (int c = 0; c < count[side]; ++c) {
        cells[side][static_cast<size_t>(c)] = parents[side].child(shapes[side], c);
      }
    }
  }

  template <class Inclusion>
  void prepare(Inclusion& inclusion) const {
    for (size_t side = 0; side < 2; ++side) {
      inclusion.prepare(static_cast<int>(side),
                        std::span(cells[side]).first(static_cast<size_t>(count[side])));
    }
  }
};

/// The windows in which the parts of a pair with window w are tested.
template <class Inclusion>
auto time_parts(const Window& w) {
  if constexpr (requires { requires Inclusion::kSplitsTime; }) {
    const double middle = std::midpoint(w.lo, w.hi);
    return std::array{Window{w.lo, middle}, Window{middle, w.hi}};
  } else {
    return std::array{w};
  }
}

/// What an inclusion counts that computes exactly.
template <class Inclusion>
std::uint64_t exact_work(const Inclusion& inclusion) {
  if constexpr (requires { inclusion.exact_work(); }) return inclusion.exact_work();
  return 0;
}

/// The branch-and-bound that all inclusion-based methods share (Section 3, Overall Pipeline). Its
/// queue has cell pairs by ascending start of their window, then the deeper first, then the older.
/// A pair whose cells are narrow enough is a hit at the start of its window. Any other is split at
/// the midpoints of all its parameters. Parts outside of a patch's trim are left out, and the
/// inclusion test is run on every pair of the others.
///
/// Inclusion is the method. It provides
///   void begin(const Query&)                     once, before anything else
///   void prepare(int side, std::span<const Cell> parts)
///       makes the sub-patches of the parts of patch `side` that the next tests name; when the
///       parent pair is split, and once for the whole patches
///   std::optional<Window> test(int part_a, int part_b, Window w)
///       the part of w in which the two parts may touch; nothing if they are separated throughout
/// Its exact_work(), if it has one, is what it did since begin, for max_work.
/// An Inclusion with kSplitsTime has each window halved too, before the test. Then a hit is as
/// narrow in time, relative to the time step, as in the parameters.
/// Guarantee: if test never drops a contact time of a pair that touches in w, the search misses no
/// contact. Its toi is then a lower bound of the first one, so no hit is late.
/// One object serves one thread. It keeps its buffers between queries, and no other state.
template <class Inclusion>
class Search {
 public:
  /// parts: what the inclusion is made of.
  template <class... Parts>
  requires std::constructible_from<Inclusion, Parts...>
  explicit Search(Parts&&... parts) : inclusion_(std::forward<Parts>(parts)...) {}

  /// Any bits may be asked about. What is no valid query (is_taken) is refused; the inclusion is
  /// given valid queries alone. toi is the start of the first window that was narrow enough.
  Answer answer(const Query& query, const SearchOptions& options) {
    if (!is_taken(query, options)) return refusal(query, options);
    const FpGuard guard;
    Answer answer = decide(query, options);
    answer.work = exact_work(inclusion_);
    queue_.clear();
    queue_.keep_at_most(kKeptBytes / 4);  // the rest is for the inclusion's tables
    return answer;
  }

 private:
  struct Entry {
    Window window;
    std::array<Cell, 2> cells;
    std::uint64_t order = 0;  ///< 4 times when it came, and crossed()

    /// Bit s: a loop of patch s meets its cell.
    unsigned crossed() const { return order & 3; }

    /// True iff x is to be taken after y.
    static bool later(const Entry& x, const Entry& y) {
      if (x.window.lo != y.window.lo) return x.window.lo > y.window.lo;
      if (x.cells[0].depth != y.cells[0].depth) return x.cells[0].depth < y.cells[0].depth;
      return x.order > y.order;
    }
  };

  Answer decide(const Query& query, const SearchOptions& options) {
    const int target = depth_for(options.precision);
    Deadline deadline(options);
    const std::array<Shape, 2> shapes = {query.patches[0].shape, query.patches[1].shape};
    const int work_of_test = shapes[0].control_count() + shapes[1].control_count();
    Answer answer;
    queue_.clear();
    pushed_ = 0;

    inclusion_.begin(query);
    parts_.assign(query);
    parts_.prepare(inclusion_);
    if (const auto w = inclusion_.test(0, 0, Window{0, query.t_max})) push(*w, 0, 0);

    while (!queue_.empty()) {
      const double earliest = queue_[0].window.lo;
      if (answer.pops == options.max_pops) return give_up(answer, earliest, "pop");
      answer.bytes = std::max(answer.bytes, queue_.bytes());
      if (queue_.bytes() > options.max_bytes) return give_up(answer, earliest, "memory");
      if (deadline.passed(0)) return give_up(answer, earliest, "time");
      const Entry entry = queue_.pop();
      ++answer.pops;
      if (entry.cells[0].depth >= target) {
        answer.verdict = Verdict::kHit;
        answer.toi = entry.window.lo;
        for (int s = 0; s < 2; ++s) answer.uv[s] = entry.cells[s].centre(shapes[s]);
        return answer;
      }
      parts_.split(shapes, entry.cells);
      parts_.trim(entry.cells, entry.crossed());
      parts_.prepare(inclusion_);
      for (const Window& window : time_parts<Inclusion>(entry.window)) {
        for (int a = 0; a < parts_.count[0]; ++a) {
          for (int b = 0; b < parts_.count[1]; ++b) {
            if (!parts_.counts(a, b)) continue;
            if (deadline.passed(work_of_test)) return give_up(answer, entry.window.lo, "time");
            if (exact_work(inclusion_) > options.max_work) {
              return give_up(answer, entry.window.lo, "work");
            }
            if (const auto w = inclusion_.test(a, b, window)) push(*w, a, b);
          }
        }
      }
    }
    answer.verdict = Verdict::kMiss;
    return answer;
  }

  /// Parts a and b.
  void push(const Window& window, int a, int b) {
    queue_.push(
        {window, {parts_.cells[0][a], parts_.cells[1][b]}, 4 * pushed_++ + parts_.crossed(a, b)});
  }

  /// Undecided, with the earliest time at which a contact may still be.
  static Answer give_up(Answer answer, double earliest, const char* budget) {
    answer.verdict = Verdict::kUndecided;
    answer.toi = earliest;
    answer.note = std::string(budget) + " budget exhausted";
    return answer;
  }

  Inclusion inclusion_;
  PairParts parts_;
  SearchQueue<Entry> queue_;
  std::uint64_t pushed_ = 0;
};

}  // namespace ccdfuzz
