// What tdibm-c takes for linear queries, and how many it leaves to integers.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "ccd/certified/tdibm_c.hpp"
#include "eval/log_histogram.hpp"
#include "io/cpu_time.hpp"

namespace ccdfuzz {
namespace {

constexpr int kQueries = 20'000;
constexpr int kRepeats = 15;

/// Positions and velocities of all bits in [−1, 1], and t_max = 1.
std::vector<Query> random_queries(const Shape& a, const Shape& b) {
  std::mt19937_64 bits(1);
  std::vector<Query> queries(kQueries);
  for (Query& query : queries) {
    query.patches[0].shape = a;
    query.patches[1].shape = b;
    for (MovingPatch<double>& patch : query.patches) {
      patch.positions.resize(static_cast<std::size_t>(patch.shape.control_count()));
      patch.velocities = patch.positions;
      for_each_coordinate(
          patch, [&](double& x) { x = std::uniform_real_distribution<double>(-1, 1)(bits); });
    }
  }
  return queries;
}

/// The least time of each query, of kRepeats.
void linear(benchmark::State& state, const Shape& a, const Shape& b) {
  const std::vector<Query> queries = random_queries(a, b);
  TdibmC method;
  LogHistogram micros;
  for ([[maybe_unused]] const auto _ : state) {
    for (const Query& query : queries) {
      double least = std::numeric_limits<double>::infinity();
      for (int i = 0; i < kRepeats; ++i) {
        const double begin = thread_cpu_seconds();
        benchmark::DoNotOptimize(method.answer(query, {}));
        least = std::min(least, thread_cpu_seconds() - begin);
      }
      micros.add(1e6 * least);
    }
  }
  const auto asked = static_cast<double>(micros.count()) * kRepeats;
  const certified::Tiers tiers = method.tiers();
  state.counters["integers_percent"] = 100 * static_cast<double>(tiers.integers) / asked;
  state.counters["mean_us"] = micros.mean();
  state.counters["p99_us"] = micros.p99();
  state.counters["p99.9_us"] = micros.quantile(0.999);
}

const bool kRegistered = [] {
  const Shape point = Shape::point(), edge = Shape::curve(1), face = Shape::triangle(1);
  for (const auto& [name, a, b] : {std::tuple{"edge-edge", edge, edge},
                                   {"vertex-face", point, face},
                                   {"point-edge", point, edge},
                                   {"point-point", point, point}}) {
    benchmark::RegisterBenchmark(fmt::format("linear/{}", name).c_str(), linear, a, b)
        ->Iterations(1);
  }
  return true;
}();

}  // namespace
}  // namespace ccdfuzz
