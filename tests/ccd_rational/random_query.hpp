#pragma once

#include <cmath>

#include "bezier/cell.hpp"
#include "bezier/random_patch.hpp"
#include "case/query.hpp"

namespace ccdfuzz {

/// Coordinates of one kind.
struct RandomCoordinates {
  enum Kind {
    kLattice,      ///< {−2..2}: ties and touches abound
    kDyadic,       ///< multiples of 2^-6
    kFull,         ///< full mantissas
    kLarge,        ///< full mantissas, all magnitudes near 1: every rounding error counts
    kAnyExponent,  ///< magnitudes all over the range within one patch
    kSubnormal     ///< x = 1, the rest a few least doubles: nothing but underflow
  } kind = kLattice;

  static RandomCoordinates any() {
    return {*rc::gen::element(kLattice, kDyadic, kFull, kLarge, kAnyExponent, kSubnormal)};
  }

  double draw() const {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>() * 0x9e3779b97f4a7c15ULL;
    const double full = std::ldexp(static_cast<double>(static_cast<std::int64_t>(bits)), -63);
    switch (kind) {
      case kLattice:
        return *rc::gen::inRange(-2, 3);
      case kDyadic:
        return std::ldexp(*rc::gen::inRange(-4096, 4097), -6);
      case kFull:
        return full;
      case kLarge:
        return (*rc::gen::inRange(0, 8) == 0 ? -1 : 1) * (0.75 + full / 4);
      case kAnyExponent:
        return std::ldexp(full, *rc::gen::inRange(-1074, 1001));
      case kSubnormal:
        return std::ldexp(*rc::gen::inRange(-3, 4), -1074);
    }
    return 0;
  }

  Points<double> points(const Shape& shape) const {
    Points<double> out;
    for (int i = 0; i < shape.control_count(); ++i) {
      const double x = kind == kSubnormal ? 1 : draw(), y = draw(), z = draw();
      out.push_back({x, y, z});
    }
    return out;
  }
};

inline MovingPatch<double> any_moving_patch(const RandomCoordinates& positions,
                                            const RandomCoordinates& velocities, int max_degree) {
  const Shape shape = *any_shape(max_degree);
  return {shape, positions.points(shape), velocities.points(shape)};
}

inline double any_t_max() {
  return *rc::gen::element(1.0, 2.0, 0.1, 1 + 0x1p-30, 0.0, 0x1p-1074, 0x1.8p-1073, 0x1p900, 3.0);
}

/// Two patches of any shapes with coordinates of one kind, or of any, and any horizon.
inline Query any_query(int max_degree, const RandomCoordinates& positions,
                       const RandomCoordinates& velocities) {
  const MovingPatch<double> a = any_moving_patch(positions, velocities, max_degree);
  const MovingPatch<double> b = any_moving_patch(positions, velocities, max_degree);
  return {{a, b}, any_t_max()};
}
inline Query any_query(int max_degree, const RandomCoordinates& coordinates) {
  return any_query(max_degree, coordinates, coordinates);
}
inline Query any_query(int max_degree = 3) {
  const RandomCoordinates positions = RandomCoordinates::any(),
                          velocities = RandomCoordinates::any();
  return any_query(max_degree, positions, velocities);
}

/// All children of one cell, and one of them.
struct CellFamily {
  std::array<Cell, 4> parts;
  size_t size = 1;
  int chosen = 0;

  std::span<const Cell> all() const { return std::span(parts).first(size); }
  const Cell& cell() const { return parts[static_cast<size_t>(chosen)]; }
};

/// The family of a random cell at `depth` ≥ 1, or the root alone.
inline CellFamily any_family(const Shape& shape, int depth) {
  CellFamily family;
  if (depth == 0) return family;
  Cell parent;
  for (int d = 1; d < depth; ++d) {
    parent = parent.child(shape, *rc::gen::inRange(0, shape.child_count()));
  }
  family.size = static_cast<size_t>(shape.child_count());
  for (int c = 0; c < shape.child_count(); ++c) {
    family.parts[static_cast<size_t>(c)] = parent.child(shape, c);
  }
  family.chosen = *rc::gen::inRange(0, shape.child_count());
  return family;
}

}  // namespace ccdfuzz
