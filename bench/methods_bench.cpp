// tdibm-c against the methods of the paper, its forms as written, and the exact one. They run on
// generated cases of each contact class: positives up to t* and negatives up to t* − 2^-20.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/generated_queries.hpp"
#include "bench/ratio.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

constexpr std::uint64_t kQueryCases = 4;
/// trad takes minutes where patches are nearly parallel: its time is a lower bound.
constexpr std::uint64_t kPopsOfTrad = 2'000;

void compare_queries(benchmark::State& state, ContactClass contact, const char* first,
                     const char* second) {
  const auto a = make_method(first), b = make_method(second);
  const std::vector<Query> all = generated_queries(contact, kQueryCases);
  SearchOptions options_of_first;
  const SearchOptions options;
  if (std::string_view(first) == "trad") options_of_first.max_pops = kPopsOfTrad;
  Ratio ratio;
  for ([[maybe_unused]] const auto _ : state) {
    for (const Query& query : all) {
      ratio.first([&] { benchmark::DoNotOptimize((*a)->answer(query, options_of_first)); });
      ratio.second([&] { benchmark::DoNotOptimize((*b)->answer(query, options)); });
    }
  }
  ratio.report(state, first, second);
}

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
  SearchOptions options;
  options.precision = 0x1p-30;
  options.max_seconds = kLimit;
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

const bool kQueriesRegistered = [] {
  for (const ContactClass contact : kContactClasses) {
    for (const char* other :
         {"trad", "tdibm", "tdibm-h:1e-12", "tdibm-e", "tdibm-e@unoptimised", "tdibm-rational"}) {
      benchmark::RegisterBenchmark(fmt::format("{}/{}:tdibm-c", name_of(contact), other).c_str(),
                                   compare_queries, contact, other, "tdibm-c")
          ->Unit(benchmark::kMillisecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace ccdfuzz
