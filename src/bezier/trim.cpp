#include "bezier/trim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bezier/orientation.hpp"

namespace ccdfuzz {

namespace {

using Loop = std::vector<Uv<double>>;

/// Requires u and v to be finite.
bool is_in_domain(const Shape& shape, const Uv<double>& uv) {
  for (const double x : uv) {
    if (compare(x, 0) < 0 || compare(x, 1) > 0) return false;
  }
  return shape.kind == ShapeKind::kTensor || orientation({1, 0}, {0, 1}, uv) >= 0;
}

const Uv<double>& next(const Loop& loop, size_t i) {
  return loop[i + 1 == loop.size() ? 0 : i + 1];
}

/// How two segments meet.
enum class Meeting { kNone, kTouch, kCross };

Meeting meeting(const Uv<double>& a, const Uv<double>& b, const Uv<double>& c,
                const Uv<double>& d) {
  const int of_c = orientation(a, b, c), of_d = orientation(a, b, d);
  if (of_c * of_d > 0) return Meeting::kNone;
  const int of_a = orientation(c, d, a), of_b = orientation(c, d, b);
  if (of_a * of_b > 0) return Meeting::kNone;
  if (of_c * of_d < 0 && of_a * of_b < 0) return Meeting::kCross;
  const bool touch = is_on_segment(c, a, b) || is_on_segment(d, a, b) || is_on_segment(a, c, d) ||
                     is_on_segment(b, c, d);
  return touch ? Meeting::kTouch : Meeting::kNone;
}

/// Edges i and j > i of one loop share more than the vertex between them.
bool meet_themselves(const Loop& loop, size_t i, size_t j) {
  const Uv<double>&a = loop[i], &b = next(loop, i), &c = loop[j], &d = next(loop, j);
  if (j == i + 1) return is_on_segment(d, a, b) || is_on_segment(a, c, d);
  if (i == 0 && j + 1 == loop.size()) return is_on_segment(c, a, b) || is_on_segment(b, c, d);
  return meeting(a, b, c, d) != Meeting::kNone;
}

bool has_both_sides(const Loop& vertices, const Loop& loop) {
  bool inside = false, outside = false;
  for (const Uv<double>& p : vertices) {
    const int place = place_of(p, loop);
    inside |= place > 0;
    outside |= place < 0;
  }
  return inside && outside;
}

std::optional<InputError> fault_of_loop(const Loop& loop, size_t place, const Shape& shape) {
  const std::string path = fmt::format("trim[{}]", place);
  const auto fault = [&](std::string what) { return InputError{path, std::move(what)}; };
  if (loop.size() < 3) return fault(fmt::format("has {} vertices, and needs 3", loop.size()));
  for (size_t i = 0; i < loop.size(); ++i) {
    const auto& [u, v] = loop[i];
    if (!is_finite(u) || !is_finite(v)) {
      return InputError{fmt::format("{}[{}]", path, i),
                        fmt::format("({}, {}) is not finite", u, v)};
    }
    if (!is_in_domain(shape, loop[i])) {
      return InputError{
          fmt::format("{}[{}]", path, i),
          fmt::format("({}, {}) lies outside the domain of a {}, {}", u, v, name_of(shape.kind),
                      shape.kind == ShapeKind::kTensor ? "u and v in [0, 1]"
                                                       : "u ≥ 0, v ≥ 0 and u + v ≤ 1")};
    }
  }
  const auto other = std::ranges::find_if(loop, [&](const Uv<double>& p) { return p != loop[0]; });
  const bool has_area = std::ranges::any_of(
      other, loop.end(), [&](const Uv<double>& p) { return orientation(loop[0], *other, p) != 0; });
  if (!has_area) return fault("has no area");
  for (size_t j = 1; j < loop.size(); ++j) {
    const auto i = std::ranges::find(loop, loop[j]) - loop.begin();
    if (std::cmp_equal(i, j)) continue;
    return fault(fmt::format(
        "vertex {} repeats vertex {}{}", j, i,
        i == 0 && j + 1 == loop.size() ? ": the last vertex is joined to the first anyway" : ""));
  }
  for (size_t i = 0; i < loop.size(); ++i) {
    for (size_t j = i + 1; j < loop.size(); ++j) {
      if (!meet_themselves(loop, i, j)) continue;
      return fault(
          fmt::format("crosses or touches itself at the edges from vertices {} and {}", i, j));
    }
  }
  return std::nullopt;
}

bool have_crossing(const Loop& p, const Loop& q) {
  for (size_t i = 0; i < p.size(); ++i) {
    for (size_t j = 0; j < q.size(); ++j) {
      if (meeting(p[i], next(p, i), q[j], next(q, j)) == Meeting::kCross) return true;
    }
  }
  return has_both_sides(p, q) || has_both_sides(q, p);
}

}  // namespace

int place_of(const Uv<double>& p, const Loop& loop) {
  bool odd = false;
  for (size_t i = 0; i < loop.size(); ++i) {
    if (is_on_segment(p, loop[i], next(loop, i))) return 0;
    odd ^= crosses_ray(p, loop[i], next(loop, i));
  }
  return odd ? 1 : -1;
}

std::optional<InputError> fault_of(const Trim& trim, const Shape& shape) {
  if (trim.empty()) return std::nullopt;
  const auto fault = [](std::string what) { return InputError{"trim", std::move(what)}; };
  if (shape.kind != ShapeKind::kTensor && shape.kind != ShapeKind::kTriangle) {
    return fault(
        fmt::format("only a triangle or a tensor is trimmed, not a {}", name_of(shape.kind)));
  }
  size_t vertices = 0;
  for (const Loop& loop : trim) vertices += loop.size();
  if (vertices > kMaxTrimVertices) {
    return fault(fmt::format("has {} vertices, and may have {}", vertices, kMaxTrimVertices));
  }
  for (size_t i = 0; i < trim.size(); ++i) {
    if (auto of_loop = fault_of_loop(trim[i], i, shape)) return of_loop;
  }
  for (size_t i = 0; i < trim.size(); ++i) {
    for (size_t j = i + 1; j < trim.size(); ++j) {
      if (have_crossing(trim[i], trim[j])) {
        return InputError{fmt::format("trim[{}]", j), fmt::format("crosses loop {}", i)};
      }
    }
  }
  return std::nullopt;
}

}  // namespace ccdfuzz
