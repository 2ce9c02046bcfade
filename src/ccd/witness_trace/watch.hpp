#pragma once

#include "ccd/witness_trace/trace.hpp"
#include "ccd/witness_trace/witness_path.hpp"

namespace ccdfuzz {

/// Listens to the inclusion tests of the pairs that contain a witness and writes the trace.
class WitnessWatch final : public ExclusionObserver {
 public:
  /// time: the witness's, in the time scale of the method.
  /// steps: write down every pair.
  void begin(const TimeBounds& time, bool steps);

  bool holds(const Window& window) const { return time_.within(window); }

  /// The next test is of this pair.
  void look_at(const TracePlace& place);
  /// Its result: the window that is left. Returns whether the witness is in it.
  bool judge(const std::optional<Window>& left);

  void excluded(const ExcludedInterval& exclusion) override;
  void compared(const SignedGap& gap) override;

  const Trace& trace() const { return trace_; }
  Trace& trace() { return trace_; }

 private:
  TimeBounds time_;
  Trace trace_;
  TracePlace place_;
  std::optional<ExcludedInterval> claim_;  ///< the first of this test that contains the witness
  std::optional<Trace::Margin> margin_;    ///< in this test
  bool steps_ = false;
};

}  // namespace ccdfuzz
