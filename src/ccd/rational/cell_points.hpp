#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "bezier/cell.hpp"
#include "bezier/patch.hpp"
#include "ccd/certified/midpoint_program.hpp"
#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz::exact_ccd {

/// Control points of one cell in double precision, as six arrays: positions x, y, z, then
/// velocities x, y, z.
struct CellPoints {
  const double* data = nullptr;
  int count = 0;

  const double* position(int k) const { return data + std::ptrdiff_t{k} * count; }
  const double* velocity(int k) const { return data + std::ptrdiff_t{3 + k} * count; }
};

/// Makes the control points of cells and remembers the most recent families: the search splits the
/// same cell against many partners. Bounded, direct mapped, no allocation after the first query of
/// a size.
///
/// Rounding: the parent is restrict_to<double> of the whole patch, its children are averages of
/// averages; roundings() bounds how many lie behind a control point. Both of a rational patch are
/// made of w·p, w·v and w, and the w of a control point then divides.
class CellPointsCache {
 public:
  /// weights: one a control point, the largest in [1, 2); or none.
  void begin(const Shape& shape, const Points<double>& positions, const Points<double>& velocities,
             const std::vector<double>& weights = {});

  /// The control points of the children of one cell (or of the root alone). Valid until the next
  /// call.
  CellPoints family(std::span<const Cell> parts);

  /// Member c of a family.
  static CellPoints member(const CellPoints& family, int c) {
    return {family.data + std::ptrdiff_t{6} * family.count * c, family.count};
  }

  static int roundings(const Shape& shape, bool is_rational = false);

 private:
  static constexpr size_t kSlots = 128;

  struct Slot {
    Cell first;
    size_t size = 0;  ///< 0: empty
  };
  using Control = std::array<double, 7>;  ///< position, velocity, and of a rational patch weight

  void fill(std::span<const Cell> parts, double* out);
  template <class Place>
  void store(const Place& place, double* out) const;

  Shape shape_;
  Points<double> positions_, velocities_, weights_, part_;
  std::optional<certified::MidpointProgram> program_;
  std::vector<Control> controls_;  ///< as the program numbers them
  std::array<Slot, kSlots> slots_;
  std::vector<double> points_;
};

}  // namespace ccdfuzz::exact_ccd
