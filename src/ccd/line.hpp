#pragma once

#include <array>

#include "base/verify.hpp"
#include "bezier/shape.hpp"
#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz {

/// slope·t + intercept: a control point's height on an axis over time (Eq. 4).
/// slope [length/time], intercept [length].
template <class S>
struct Line {
  S slope;
  S intercept;

  S at(const S& t) const { return S(S(slope * t) + intercept); }
};

/// Up to kMaxControls lines, in place: the hot path allocates nothing.
template <class S>
class Lines {
 public:
  int size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void clear() { size_ = 0; }
  void push_back(const Line<S>& line) {
    CCDFUZZ_ASSERT(size_ < kMaxControls);
    lines_[size_++] = line;
  }
  void pop_back() { --size_; }

  Line<S>& operator[](int i) { return lines_[i]; }
  const Line<S>& operator[](int i) const { return lines_[i]; }
  const Line<S>& back() const { return lines_[size_ - 1]; }
  const Line<S>* begin() const { return lines_.data(); }
  const Line<S>* end() const { return lines_.data() + size_; }

 private:
  std::array<Line<S>, kMaxControls> lines_;
  int size_ = 0;
};

/// Sorts by slope, lines of equal slope by intercept, both ascending. Shell's method: plain
/// insertion for few lines, a few passes for many, no allocation. It ends in some order where a
/// coefficient is NaN after overflow.
template <class S>
void sort_lines(Lines<S>& lines) {
  const auto before = [](const Line<S>& x, const Line<S>& y) {
    return x.slope < y.slope || (x.slope == y.slope && x.intercept < y.intercept);
  };
  for (const int gap : {23, 10, 4, 1}) {
    if (gap > 1 && 3 * gap > lines.size()) continue;
    for (int i = gap; i < lines.size(); ++i) {
      const Line<S> line = lines[i];
      int j = i;
      for (; j >= gap && before(line, lines[j - gap]); j -= gap) lines[j] = lines[j - gap];
      lines[j] = line;
    }
  }
}

/// The lines of −f for each sorted line f, sorted again; exact.
template <class S>
void negate_lines(const Lines<S>& sorted, Lines<S>& out) {
  out.clear();
  for (int i = sorted.size() - 1; i >= 0; --i) {
    out.push_back({S(-sorted[i].slope), S(-sorted[i].intercept)});
  }
}

}  // namespace ccdfuzz
