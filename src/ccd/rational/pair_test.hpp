#pragma once

#include <array>
#include <optional>
#include <span>

#include "ccd/exclusion.hpp"
#include "ccd/rational/gap.hpp"
#include "ccd/rational/pair_axes.hpp"
#include "ccd/rational/window.hpp"
#include "ccd/search.hpp"

namespace ccdfuzz::exact_ccd {

/// The inclusion test of TdibmRational: the part of a window in which no axis of the pair
/// separates two cells.
class PairTest {
 public:
  void begin(const Query& query);
  void prepare(int side, std::span<const Cell> parts);
  std::optional<Window> test(int part_a, int part_b, const Window& window,
                             ExclusionObserver* observer = nullptr);

  std::uint64_t exact_work() const { return gap_.exact_work(); }

 private:
  const BoxDirections& frame(int side, int part, double t);
  /// What cut_window did to a window with the axis that the gap is projected on.
  void tell(ExclusionObserver& observer, int axis, const IntegerAxis& direction,
            const Window& before, bool is_left, const Window& after) const;

  Gap gap_;
  std::array<Shape, 2> shapes_;
  /// Frames of the prepared parts at the start of the first window tested.
  std::array<std::array<std::optional<BoxDirections>, 4>, 2> frames_;
  /// Axes of the pair at hand at apart_time_, if the query has a separation.
  std::optional<certified::CandidateAxes> apart_;
  double apart_time_ = 0;
  bool is_apart_ = false;
  int axis_bits_ = 0;
};

}  // namespace ccdfuzz::exact_ccd
