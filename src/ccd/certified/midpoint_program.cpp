#include "ccd/certified/midpoint_program.hpp"

#include <array>
#include <map>

namespace ccdfuzz::certified {

namespace {

/// How often each corner or midpoint stands among the arguments of a blossom. Triangle: the corners
/// w, u, v, then the midpoints wu, wv, uv. Curve and tensor: u = 0, 1, ½, then v = 0, 1, ½.
using Arguments = std::array<int, 6>;

class Builder {
 public:
  Builder(const Shape& shape, MidpointProgram& program) : shape_(shape), program_(program) {}

  /// The slot of a polar value; b(½(x+y), …) = ½(b(x, …) + b(y, …)) splits one midpoint off.
  int slot(Arguments a) {
    if (const auto known = slots_.find(a); known != slots_.end()) return known->second;
    const auto split = [&](int mid, int x, int y) {
      Arguments left = a, right = a;
      --left[mid], ++left[x];
      --right[mid], ++right[y];
      const int l = slot(left), r = slot(right);
      program_.steps.push_back({l, r});
      return shape_.control_count() + static_cast<int>(program_.steps.size()) - 1;
    };
    int found = 0;
    if (shape_.kind == ShapeKind::kTriangle) {
      found = a[3] > 0   ? split(3, 0, 1)
              : a[4] > 0 ? split(4, 0, 2)
              : a[5] > 0 ? split(5, 1, 2)
                         : shape_.index(a[1], a[2]);
    } else {
      found = a[2] > 0 ? split(2, 0, 1) : a[5] > 0 ? split(5, 3, 4) : shape_.index(a[1], a[4]);
    }
    return slots_[a] = found;
  }

 private:
  const Shape& shape_;
  MidpointProgram& program_;
  std::map<Arguments, int> slots_;
};

}  // namespace

MidpointProgram::MidpointProgram(const Shape& shape) {
  Builder builder(shape, *this);
  children.resize(static_cast<size_t>(shape.child_count()));
  roundings = shape.n + shape.m;
  // Corners (origin, u end, v end) of each child of a triangle among w, u, v, wu, wv, uv. The
  // middle child is turned: its origin is the corner with both coordinates higher (Cell::corners).
  constexpr std::array<std::array<int, 3>, 4> corners = {
      {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}, {5, 4, 3}}};
  for (size_t c = 0; c < children.size(); ++c) {
    const bool high_u = (c & 1) != 0, high_v = (c & 2) != 0;
    for_each_control(shape, [&](int i, int j) {
      Arguments a{};
      if (shape.kind == ShapeKind::kTriangle) {
        a[corners[c][0]] += shape.n - i - j;
        a[corners[c][1]] += i;
        a[corners[c][2]] += j;
      } else {
        a[high_u ? 2 : 0] += shape.n - i;
        a[high_u ? 1 : 2] += i;
        a[high_v ? 5 : 3] += shape.m - j;
        a[high_v ? 4 : 5] += j;
      }
      children[c].push_back(builder.slot(a));
    });
  }
}

}  // namespace ccdfuzz::certified
