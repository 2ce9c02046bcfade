#pragma once

#include <benchmark/benchmark.h>

#include "io/cpu_time.hpp"

namespace ccdfuzz {

/// Times two ways to do the same thing turn by turn on the same inputs, in CPU time of the thread.
/// So their ratio depends little on the machine and on what else it does. Counters: the mean time
/// of one input each, in seconds, and first/second.
class Ratio {
 public:
  template <class Work>
  void first(const Work& work) {
    first_ += seconds_of(work);
    ++inputs_;
  }
  template <class Work>
  void second(const Work& work) {
    second_ += seconds_of(work);
  }

  void report(benchmark::State& state, const char* first_name, const char* second_name) const {
    state.counters[first_name] = first_ / static_cast<double>(inputs_);
    state.counters[second_name] = second_ / static_cast<double>(inputs_);
    state.counters["ratio"] = first_ / second_;
  }

 private:
  template <class Work>
  static double seconds_of(const Work& work) {
    const double begin = thread_cpu_seconds();
    work();
    return thread_cpu_seconds() - begin;
  }

  double first_ = 0, second_ = 0;
  long inputs_ = 0;
};

}  // namespace ccdfuzz
