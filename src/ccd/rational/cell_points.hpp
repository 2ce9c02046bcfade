#pragma once

#include <span>
#include <vector>

#include "bezier/cell.hpp"
#include "bezier/patch.hpp"

namespace ccdfuzz::exact_ccd {

/// Control points of one cell in double precision, as six arrays of shape.control_count() numbers:
/// positions x, y, z, then velocities x, y, z.
struct CellPoints {
  const double* data = nullptr;
  int count = 0;

  const double* position(int k) const { return data + k * count; }
  const double* velocity(int k) const { return data + (3 + k) * count; }
};

/// Makes the control points of cells from scratch and remembers the most recent families: the
/// search splits the same cell against many partners. Bounded, direct mapped, no allocation after
/// the first query of a size.
class CellPointsCache {
 public:
  void begin(const Shape& shape, const Points<double>& positions, const Points<double>& velocities);

  /// The control points of the children of one cell (or of the root alone). Valid until the next
  /// call. Rounding: each is restrict_to<double> of the whole patch.
  CellPoints family(std::span<const Cell> parts);

  /// Member c of a family.
  static CellPoints member(const CellPoints& family, int c) {
    return {family.data + std::ptrdiff_t{6} * family.count * c, family.count};
  }

 private:
  static constexpr size_t kSlots = 64;

  struct Slot {
    Cell first;
    size_t size = 0;  ///< 0: empty
  };

  void fill(std::span<const Cell> parts, double* out);

  Shape shape_;
  Points<double> positions_, velocities_, part_;
  std::array<Slot, kSlots> slots_;
  std::vector<double> points_;
};

}  // namespace ccdfuzz::exact_ccd
