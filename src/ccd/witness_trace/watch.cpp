#include "ccd/witness_trace/watch.hpp"

#include <bit>
#include <cmath>

namespace ccdfuzz {

namespace {

/// Steps from one double to the next between 0 ≤ x ≤ y, or x < 0 ≤ y.
std::uint64_t steps_between(double x, double y) {
  const auto place = [](double d) { return std::bit_cast<std::uint64_t>(std::abs(d)); };
  return x < 0 ? place(x) + place(y) : place(y) - place(x);
}

}  // namespace

template <class Interval>
Interval WitnessWatch::in_query(Interval interval) const {
  interval.lo = std::ldexp(interval.lo, time_exponent_);
  interval.hi = std::ldexp(interval.hi, time_exponent_);
  return interval;
}

void WitnessWatch::begin(const TimeBounds& time, bool steps, int time_exponent) {
  time_ = time;
  time_exponent_ = time_exponent;
  trace_ = {};
  steps_ = steps;
}

void WitnessWatch::look_at(const TracePlace& place) {
  place_ = {place.level, place.cells, in_query(place.window)};
  claim_.reset();
  margin_.reset();
  ++trace_.pairs;
  trace_.levels = place.level;
}

bool WitnessWatch::judge(const std::optional<Window>& left) {
  const bool kept = left && holds(*left);
  const std::optional<Window> told = left ? std::optional(in_query(*left)) : left;
  if (steps_) trace_.steps.push_back({place_, told, !kept, margin_});
  if (kept) return true;
  ++trace_.lost_pairs;
  if (!trace_.lost) trace_.loss = Trace::Loss{place_, claim_.value_or(ExcludedInterval{}), told};
  trace_.lost = true;
  return false;
}

void WitnessWatch::excluded(const ExcludedInterval& exclusion) {
  std::uint64_t ulps = 0;
  ExcludedInterval told = exclusion;
  told.times = in_query(exclusion.times);
  if (time_.within(exclusion.times)) {
    ++trace_.false_claims;
    if (!claim_) claim_ = told;
  } else if (exclusion.times.hi <= time_.lo) {
    ulps = steps_between(exclusion.times.hi, time_.lo);
  } else if (exclusion.times.lo >= time_.hi) {
    ulps = steps_between(time_.hi, exclusion.times.lo);
  } else {
    return;  // an end that is no number excludes nothing
  }
  if (!margin_ || ulps < margin_->ulps) margin_ = Trace::Margin{ulps, place_, told};
  if (!trace_.margin || ulps < trace_.margin->ulps) trace_.margin = margin_;
}

void WitnessWatch::compared(const SignedGap& gap) {
  const Window& w = gap.window;
  double at_t = gap.at_lo;
  if (time_.lo == w.hi) {
    at_t = gap.at_hi;
  } else if (w.lo < time_.lo) {
    at_t += (gap.at_hi - gap.at_lo) * ((time_.lo - w.lo) / (w.hi - w.lo));
  }
  const double slack = at_t / gap.in_units_of;
  if (trace_.slack ? slack < trace_.slack->value : slack == slack) {
    trace_.slack = Trace::Slack{slack, place_, gap};
    trace_.slack->gap.window = in_query(w);
  }
}

}  // namespace ccdfuzz
