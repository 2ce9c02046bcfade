// How late methods end that are given little time. `ccdfuzz bench` compares their speed.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>

#include "method/method.hpp"

namespace ccdfuzz {
namespace {

/// By how much a time limit is exceeded, at most, on two patches of degree 8 that nearly coincide.
/// A single pair of cells takes tdibm-rational up to 30 ms there.
void overrun(benchmark::State& state, const char* spec) {
  constexpr double kLimit = 0.1;
  Query query;
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    patch.shape = Shape::tensor(8, 8);
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      const double u = i / 9 / 8.0, v = i % 9 / 8.0;
      patch.positions.push_back({u, v, u * v + (s == 0 ? 0 : 0x1p-28)});
      patch.velocities.push_back({0, 0, 0});
    }
  }
  query.t_max = 1;
  const SearchOptions options = {.precision = 0x1p-30, .max_seconds = kLimit};
  const auto method = make_method(spec);
  double most = 0;
  for ([[maybe_unused]] const auto _ : state) {
    most = std::max(most, timed_answer(**method, query, options).seconds - kLimit);
  }
  state.counters["overrun_ms"] = 1e3 * most;
}

const bool kOverrunRegistered = [] {
  for (const char* spec : {"trad", "tdibm", "tdibm-e", "tdibm-rational", "tdibm-c"}) {
    benchmark::RegisterBenchmark(fmt::format("overrun/{}", spec).c_str(), overrun, spec)
        ->Iterations(10);
  }
  return true;
}();

}  // namespace
}  // namespace ccdfuzz
