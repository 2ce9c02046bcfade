#pragma once

#include <array>
#include <span>
#include <vector>

#include "bezier/cell.hpp"
#include "case/query.hpp"
#include "ccd/axes.hpp"

namespace ccdfuzz {

/// The control nets of the cells that the pairs of one split are made of. The nets of the last few
/// hundred splits of each patch are kept. For a cell belongs to many pairs, and its net depends on
/// nothing but the patch and the cell. Allocates nothing once its tables have their size.
class SubPatches {
 public:
  /// Splits of each patch whose nets are kept.
  static constexpr size_t kSplits = 256;

  explicit SubPatches(const AxisReading& reading) : reading_(reading) {}

  /// Points at the query's patches; the query must outlive the calls of prepare.
  void begin(const Query& query);

  /// Makes the nets of the parts of patch `side`, each from the original control points (Appendix A
  /// (b)). So rounding errors do not add up over the levels. Those of a rational patch are made of
  /// w·p, w·v and w, as polynomials are, and divided by the new w.
  void prepare(int side, std::span<const Cell> parts);

  ControlNet net(int side, int part) const {
    const Shape& shape = query_->patches[side].shape;
    const auto count = static_cast<size_t>(shape.control_count());
    const Vec3<double>* points = parts_[side][part].points;
    return {shape, {points, count}, {points + count, count}};
  }

  /// The OBB axes of part a of patch 1 and part b of patch 2, aligned at time t. Where neither
  /// patch is a surface and both frames are zero, the coordinate axes stand in.
  ObbAxes axes(int part_a, int part_b, double t);

 private:
  struct Part {
    /// The positions, then the velocities.
    const Vec3<double>* points;
    /// The frame at frame_time, which is NaN if there is none yet.
    Frame frame;
    double frame_time;
  };
  /// The nets of sibling cells, in a direct-mapped cache: the first cell of a family is its key.
  struct Families {
    std::array<Cell, kSplits> first;
    std::array<size_t, kSplits> parts;  ///< how many; 0 if there are none yet
    std::vector<Vec3<double>> points;
  };

  /// Positions and velocities times their weights, and the weights, of a rational patch.
  struct Homogeneous {
    Points<double> positions, velocities, weights, new_weights;
  };

  const Frame& frame(int side, int part, double t);

  AxisReading reading_;
  const Query* query_ = nullptr;
  std::array<std::array<Part, 4>, 2> parts_;
  std::array<Families, 2> kept_;
  std::array<Homogeneous, 2> homogeneous_;
};

}  // namespace ccdfuzz
