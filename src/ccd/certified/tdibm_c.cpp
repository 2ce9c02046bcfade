#include "ccd/certified/tdibm_c.hpp"

#include <chrono>

#include "ccd/certified/pair_axes.hpp"
#include "numeric/fp_guard.hpp"

namespace ccdfuzz {

using namespace certified;  // NOLINT: this file is that namespace's one method

namespace {

/// The queue orders by the window's start in steps of t_max·2^-20, deeper first within a step:
/// near-ties go deep rather than wide. toi does not suffer: it is the least start of all that is
/// left.
constexpr double kTimeSteps = 0x1p20;

}  // namespace

bool TdibmC::later(const Entry& x, const Entry& y) {
  if (x.steps != y.steps) return x.steps > y.steps;
  if (x.depth != y.depth) return x.depth < y.depth;
  return x.key > y.key;
}

Answer TdibmC::answer(const Query& query, const SearchOptions& options) {
  const FpGuard guard;
  const auto start = std::chrono::steady_clock::now();
  Answer answer = decide(query, options);
  const auto end = std::chrono::steady_clock::now();
  answer.seconds = std::chrono::duration<double>(end - start).count();
  return answer;
}

size_t TdibmC::bytes() const {
  return queue_.size() * sizeof(Entry) + trees_[0].bytes() + trees_[1].bytes();
}

double TdibmC::earliest(double so_far) const {
  for (const Entry& e : queue_) so_far = std::min(so_far, e.window.lo);
  return original_time(so_far, query_.time);
}

void TdibmC::push(const Window& window, const Axis& hint, Node a, Node b, int depth) {
  const double steps = query_.t_max > 0 ? window.lo / query_.t_max * kTimeSteps : 0;
  queue_.push_back({window,
                    hint,
                    pushed_++,
                    {a, b},
                    static_cast<std::uint32_t>(steps),
                    static_cast<std::uint16_t>(depth)});
  std::push_heap(queue_.begin(), queue_.end(), later);
}

Answer TdibmC::decide(const Query& query, const SearchOptions& options) {
  const int target = depth_for(options.precision);
  query_ = normalise(query);
  for (int s = 0; s < 2; ++s) trees_[s].reset(query_.shapes[s], query_.controls[s]);
  queue_.clear();
  pushed_ = 0;
  push({0, query_.t_max}, {}, 0, 0, 0);

  Answer answer;
  while (!queue_.empty()) {
    const bool out_of_pops = answer.pops == options.max_pops;
    if (out_of_pops || bytes() > options.max_bytes) {
      answer.verdict = Verdict::kUndecided;
      answer.toi = earliest(query_.t_max);
      answer.note = out_of_pops ? "pop budget exhausted" : "memory budget exhausted";
      return answer;
    }
    std::pop_heap(queue_.begin(), queue_.end(), later);
    const Entry entry = queue_.back();
    queue_.pop_back();
    ++answer.pops;
    if (entry.depth >= target) {
      answer.verdict = Verdict::kHit;
      answer.toi = earliest(entry.window.lo);
      for (int s = 0; s < 2; ++s) {
        answer.uv[s] = trees_[s].cell(entry.cells[s]).centre(query_.shapes[s]);
      }
      return answer;
    }
    expand(entry);
  }
  answer.verdict = Verdict::kMiss;
  return answer;
}

void TdibmC::expand(const Entry& entry) {
  const double middle = 0.5 * entry.window.lo + 0.5 * entry.window.hi;
  const Skeleton whole[2] = {{trees_[0], entry.cells[0], middle},
                             {trees_[1], entry.cells[1], middle}};
  const Axis shared[3] = {entry.hint, whole[0].normal, whole[1].normal};
  const ErrorBound error(
      query_.magnitude, query_.absolute,
      std::max(trees_[0].roundings(entry.depth + 1), trees_[1].roundings(entry.depth + 1)));
  double bound[6];
  for (int k = 0; k < 3; ++k) {
    bound[k] = error.for_axis(1.0);
    bound[k + 3] = error.for_axis(norm1(shared[k]));
  }

  Child children[2][4];
  for (int s = 0; s < 2; ++s) {
    const Node first = trees_[s].children(entry.cells[s]);
    for (int c = 0; c < query_.shapes[s].child_count(); ++c) {
      Child& child = children[s][c];
      child.node = first + static_cast<Node>(c);
      child.has_shared = false;
      for (int k = 0; k < 3; ++k) {
        child.coordinate[k] = project_coordinate(trees_[s].net(child.node), trees_[s].width(), k,
                                                 entry.window.lo, entry.window.hi);
      }
    }
  }
  for (int a = 0; a < query_.shapes[0].child_count(); ++a) {
    for (int b = 0; b < query_.shapes[1].child_count(); ++b) {
      Child* const pair[2] = {&children[0][a], &children[1][b]};
      bool apart = false;
      for (int k = 0; k < 3 && !apart; ++k) {
        apart = Gaps(pair[0]->coordinate[k], pair[1]->coordinate[k]).separated(bound[k]);
      }
      if (apart) continue;
      for (int s = 0; s < 2; ++s) {
        if (pair[s]->has_shared) continue;
        pair[s]->has_shared = true;
        for (int k = 0; k < 3; ++k) {
          pair[s]->shared[k] = project(trees_[s].net(pair[s]->node), trees_[s].width(), shared[k],
                                       entry.window.lo, entry.window.hi);
        }
      }
      Window w = entry.window;
      Axis hint = entry.hint;
      if (narrow(*pair[0], *pair[1], bound, error, w, hint)) {
        push(w, hint, pair[0]->node, pair[1]->node, entry.depth + 1);
      }
    }
  }
}

/// Shortens w by every axis in turn. Returns false if the pair is separated throughout.
bool TdibmC::narrow(const Child& a, const Child& b, const double bound[6], const ErrorBound& error,
                    Window& w, Axis& hint) {
  for (int k = 0; k < 3; ++k) {
    if (Gaps(a.shared[k], b.shared[k]).separated(bound[k + 3])) return false;
  }
  const Window parent = w;
  const auto trim = [&](const Gaps& gaps, double e) {
    Window trimmed = parent;
    trim_by_chord(gaps, e, trimmed);
    w.lo = std::max(w.lo, trimmed.lo);
    w.hi = std::min(w.hi, trimmed.hi);
  };
  for (int k = 0; k < 3; ++k) {
    trim(Gaps(a.coordinate[k], b.coordinate[k]), bound[k]);
    trim(Gaps(a.shared[k], b.shared[k]), bound[k + 3]);
  }
  if (w.lo > w.hi) return false;  // what two axes exclude covers the window

  const NetPair nets = {{trees_[0].net(a.node), trees_[1].net(b.node)},
                        {trees_[0].width(), trees_[1].width()}};
  const double middle = 0.5 * w.lo + 0.5 * w.hi;
  const Skeleton flat_a(trees_[0], a.node, middle), flat_b(trees_[1], b.node, middle);
  const bool apart = for_each_axis(flat_a, flat_b, [&](const Axis& l) {
    const double e = error.for_axis(norm1(l));
    const Gaps gaps(project(nets.net[0], nets.width[0], l, w.lo, w.hi),
                    project(nets.net[1], nets.width[1], l, w.lo, w.hi));
    if (gaps.separated(e)) return true;
    if (!gaps.separated_at_an_end(e)) return false;
    trim_by_chord(gaps, e, w);
    for (int sign = 0; sign < 2; ++sign) {
      const bool low = gaps.at_lo[sign] < -e, high = gaps.at_hi[sign] < -e;
      if (low || high) trim_by_newton(nets, l, e, sign, low, w);
    }
    hint = l;
    return w.lo > w.hi;  // both signs together exclude all of it
  });
  return !apart;
}

}  // namespace ccdfuzz
