#pragma once

#include "ccd/witness_trace/trace.hpp"
#include "ccd/witness_trace/witness_path.hpp"

namespace ccdfuzz {

/// Listens to the inclusion tests of the pairs that contain a witness and writes the trace.
class WitnessWatch final : public ExclusionObserver {
 public:
  /// time: the witness's, in the time scale of the method, as all times that it is told. The
  /// trace's times are those of the query, 2^time_exponent times as large. steps: write down every
  /// pair.
  void begin(const TimeBounds& time, bool steps, int time_exponent = 0);

  bool holds(const Window& window) const { return time_.within(window); }

  /// The next test is of this pair.
  void look_at(const TracePlace& place);
  /// Its result: the window that is left. Returns whether the witness is in it.
  bool judge(const std::optional<Window>& left);

  void excluded(const ExcludedInterval& exclusion) override;
  void compared(const SignedGap& gap) override;

  const Trace& trace() const { return trace_; }

 private:
  /// The same part of the time step, in the time of the query.
  template <class Interval>
  Interval in_query(Interval interval) const;

  TimeBounds time_;
  int time_exponent_ = 0;
  Trace trace_;
  TracePlace place_;
  std::optional<ExcludedInterval> claim_;  ///< the first of this test that contains the witness
  std::optional<Trace::Margin> margin_;    ///< in this test
  bool steps_ = false;
};

}  // namespace ccdfuzz
