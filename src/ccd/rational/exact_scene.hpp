#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bezier/cell.hpp"
#include "ccd/rational/axis.hpp"
#include "ccd/rational/units.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz::exact_ccd {

/// One query in integers. It decides the exact sign of the gap of two cells along an axis at a
/// time. Its numbers keep their memory.
class ExactScene {
 public:
  /// Operations on 64-bit words so far, over the life of the object.
  std::uint64_t work() const { return work_; }

  void load(const Query& query, const Units& units);

  /// The sign of h(t) + d·|l|_2, where d is the separation; −1 means separated (Eqs. 3–4). h(t) is
  /// max p·l over control points p of cell `below`, minus min q·l over control points q of the
  /// other cell, at time t. below: the side whose maximum is taken. cells: one per side, of one
  /// depth. t: a window end. candidates: per side, the control points of the cell that may attain
  /// the extreme; a superset of those that do.
  int gap_sign(int below, const std::array<Cell, 2>& cells, const IntegerAxis& axis, double t,
               const std::array<std::span<const std::uint8_t>, 2>& candidates);

 private:
  /// Parameters as integers over 2^depth.
  using IntegerUv = std::array<std::int64_t, 2>;

  /// Position, velocity and weight of a control point. Those of a cell are homogeneous: times
  /// 2^(depth·blossom_steps), which is the weight where a patch is polynomial.
  using Control = std::array<Integer, 7>;
  static constexpr size_t kWeight = 6;

  /// A height times a weight, and the weight.
  struct Height {
    Integer value;
    const Integer* weight = nullptr;
  };

  /// The control points of a cell that some predicate needed.
  struct Part {
    Cell cell;
    std::array<IntegerUv, 3> corners;
    std::array<bool, kMaxControls> made;
    std::vector<Control> points;
  };
  static constexpr int kNoDepth = -1;

  struct Side {
    Shape shape;
    std::vector<Control> controls;
    /// Those asked of last, as many as a split has children. Each of them meets all of the other
    /// side's, on many axes.
    std::array<Part, 4> parts;
    size_t oldest = 0;
  };

  void multiply(Side& s, const std::vector<double>& weights);
  static Part& part_of(Side& side, const Cell& cell);
  const Control& point(const Side& side, Part& part, int i, int j);
  const Integer& number(const Side& side, size_t k, const Part& part, int i, int j);
  const Height& extreme(size_t which, bool maximum, const Cell& cell, const IntegerAxis& axis,
                        double t, std::span<const std::uint8_t> candidates);
  bool is_beyond(const Height& a, const Height& b, bool above);
  Integer product(const Integer& x, const Integer& y);
  void set_product(Integer& out, const Integer& x, std::int64_t y);
  void add_product(Integer& sum, const Integer& x, std::int64_t y);

  Units units_;
  Integer separation_;
  std::array<Side, 2> sides_;
  std::array<Height, 2> extremes_;
  Height height_;
  std::vector<Integer> net_;
  Integer sum_;
  std::uint64_t work_ = 0;
};

}  // namespace ccdfuzz::exact_ccd
