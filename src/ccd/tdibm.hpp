#pragma once

#include <array>
#include <optional>
#include <span>

#include "ccd/exclusion.hpp"
#include "ccd/projection.hpp"
#include "ccd/search.hpp"
#include "ccd/sub_patches.hpp"

namespace ccdfuzz {

/// The time-dependent inclusion test of the paper (Section 3, Steps I–III) under a robustness
/// policy: two sub-patches may touch where no OBB axis separates their control points.
/// Claim, by Policy: test never drops a time at which the two parts touch.
template <class Policy>
class TdibmInclusion {
 public:
  explicit TdibmInclusion(Policy policy = Policy(), const Reading& reading = Policy::kReading)
      : policy_(policy), reading_(reading), parts_(reading.axes) {}

  void begin(const Query& query);
  void prepare(int side, std::span<const Cell> parts);
  std::optional<Window> test(int part_a, int part_b, const Window& window,
                             ExclusionObserver* observer = nullptr);

 private:
  /// Lines, and their upper envelope when it is asked for.
  struct Half {
    Lines<double> lines, envelope;
    bool has_envelope = false;
  };

  /// One part on one axis. Half 1 stands for the negated lines, whose upper envelope is the negated
  /// lower one.
  class OnAxis {
   public:
    /// Step I. stage_errors: eps_a, eps_b by the stage of an axis.
    void project(const Policy& policy, const ControlNet& net, const Axis& axis,
                 std::span<const CoefficientError> stage_errors, double t_hi);
    /// Step II of a half. w: the window that project had the end of.
    const Lines<double>& envelope(size_t half, const Policy& policy, const Window& w);

    const Vec3<double>& direction() const { return direction_; }
    /// No lines yet.
    void forget() { direction_ = Vec3<double>(0, 0, 0); }

   private:
    std::array<Half, 2> halves_;
    Vec3<double> direction_;
    double error_ = 0;  ///< eps_constr
  };

  OnAxis& on_axis(int side, int part, int r, const Axis& axis, const Window& window);

  Policy policy_;
  Reading reading_;
  SubPatches parts_;
  /// eps_a and eps_b of the sub-patches of each side, by the stage of the axis.
  std::array<std::array<CoefficientError, ObbAxes::kStages>, 2> stage_errors_;
  /// The axes that most lately separated a pair throughout come first: it may decide the next, too.
  std::array<int, ObbAxes::kCount> order_;
  /// Parts on their own axes in the window `seen_`, which the pairs of a split share.
  std::array<std::array<std::array<OnAxis, 3>, 4>, 2> own_;
  Window seen_{};
  std::array<OnAxis, 2> scratch_;
};

/// The paper's methods: `tdibm` (Plain), `tdibm-h:F` (PullApart), `tdibm-e` (ErrorBoundIntended),
/// `tdibm-e-literal` (ErrorBoundPrinted). toi is as safe as Policy is.
template <class Policy>
using Tdibm = Search<TdibmInclusion<Policy>>;

extern template class Search<TdibmInclusion<Plain>>;
extern template class Search<TdibmInclusion<PullApart>>;
extern template class Search<TdibmInclusion<ErrorBoundIntended>>;
extern template class Search<TdibmInclusion<ErrorBoundPrinted>>;

}  // namespace ccdfuzz
