#include "ccd/certified/moving_polygon.hpp"

#include <algorithm>
#include <limits>

#include "base/double_parts.hpp"

namespace ccdfuzz::certified {

bool MovingPolygon::begin(const Query& query) {
  const int a = query.patches[0].shape.control_count() - 1;
  const int b = query.patches[1].shape.control_count() - 1;
  if (a == 1 && b == 1) {
    corners_ = 4;
    places_ = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  } else {
    corners_ = 3;
    for (int i = 0; i < 3; ++i) {
      places_[static_cast<std::size_t>(i)] = {std::min(i, a), std::min(i, b)};
    }
  }
  return make_coordinate(query, 0) && make_coordinate(query, 1) && make_coordinate(query, 2);
}

/// The numbers of coordinate k as multiples of the largest power of two that divides all of them.
bool MovingPolygon::make_coordinate(const Query& query, std::size_t k) {
  const DoubleParts step = parts_of(query.t_max);
  // What moves a control point is `forward`, and of ends its position backward.
  std::array<std::array<DoubleParts, 3>, 2> position, forward{}, backward{};
  int least = std::numeric_limits<int>::max(), top = std::numeric_limits<int>::min();
  const auto note = [&](const DoubleParts& x, int time_exponent, int time_top) {
    if (x.mantissa == 0) return;
    least = std::min(least, x.exponent + time_exponent);
    top = std::max(top, x.top() + time_top);
  };
  for (std::size_t s = 0; s < 2; ++s) {
    const MovingPatch<double>& patch = query.patches[s];
    for (std::size_t i = 0; i < patch.positions.size(); ++i) {
      position[s][i] = parts_of(patch.positions[i][static_cast<int>(k)]);
      note(position[s][i], 0, 0);
      if (step.mantissa == 0) continue;
      forward[s][i] = parts_of(patch.moves()[i][static_cast<int>(k)]);
      if (patch.has_ends()) backward[s][i] = position[s][i];
      const int top_of_way = step.top() + (patch.has_ends() ? 1 : 0);
      note(forward[s][i], step.exponent, top_of_way);
      note(backward[s][i], step.exponent, top_of_way);
    }
  }
  // Law L7: numbers of this many binary places fit.
  if (top >= least && top - least >= kMostBits) return false;
  const std::int64_t factor = step.mantissa;
  for (std::size_t c = 0; c < corners_; ++c) {
    Int start(0), way(0);
    for (std::size_t s = 0; s < 2; ++s) {
      const auto i = static_cast<std::size_t>(places_[c][s]);
      const DoubleParts& p = position[s][i];
      const Int at = p.mantissa == 0 ? Int(0) : Int(p.mantissa) << (p.exponent - least);
      const auto way_of = [&](const DoubleParts& v) {
        if (v.mantissa == 0) return Int(0);
        return Int(v.mantissa) * factor << (v.exponent + step.exponent - least);
      };
      const Int moves = way_of(forward[s][i]) - way_of(backward[s][i]);
      start = s == 0 ? at : start - at;
      way = s == 0 ? moves : way - moves;
    }
    corner_[c][k] = TimePolynomial(start, way);
  }
  return true;
}

}  // namespace ccdfuzz::certified
