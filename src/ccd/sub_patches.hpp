#pragma once

#include <array>
#include <span>

#include "bezier/cell.hpp"
#include "ccd/axes.hpp"
#include "query/query.hpp"

namespace ccdfuzz {

/// The control nets of the cells that the pairs of one split are made of, in place.
class SubPatches {
 public:
  /// Points at the query's patches; the query must outlive the calls of prepare.
  void begin(const Query& query) { query_ = &query; }

  /// Makes the nets of the parts of patch `side`, each from the original control points
  /// (Appendix A (b)), so that rounding errors do not add up over the levels.
  void prepare(int side, std::span<const Cell> parts);

  ControlNet net(int side, int part) const {
    const Shape& shape = query_->patches[side].shape;
    const auto count = static_cast<size_t>(shape.control_count());
    const Part& p = parts_[side][part];
    return {shape, {p.positions.data(), count}, {p.velocities.data(), count}};
  }

  /// The OBB axes of part a of patch 1 and part b of patch 2, aligned at time t. Where neither
  /// patch is a surface and both frames are zero, the coordinate axes stand in.
  ObbAxes axes(int part_a, int part_b, double t);

 private:
  struct Part {
    std::array<Vec3<double>, kMaxControls> positions, velocities;
    /// The frame at frame_time, which is NaN if there is none yet.
    Frame frame;
    double frame_time;
  };
  const Frame& frame(int side, int part, double t);

  const Query* query_ = nullptr;
  std::array<std::array<Part, 4>, 2> parts_;
};

}  // namespace ccdfuzz
