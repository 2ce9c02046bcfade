// What weights cost tdibm-c: the same queries with weights and without. With equal weights they are
// the same queries. With one weight that is the next float they are nearly the same patches, which
// the rational arithmetic searches.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "bench/generated_queries.hpp"
#include "bench/ratio.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

constexpr std::uint64_t kWeightedCases = 8;

void compare_weights(benchmark::State& state, ContactClass contact, double first_weight) {
  std::vector<Query> weighted = generated_queries(contact, kWeightedCases);
  const std::vector<Query> plain = weighted;
  for (Query& query : weighted) {
    for (MovingPatch<double>& patch : query.patches) {
      patch.weights.assign(patch.positions.size(), 1);
      patch.weights[0] = first_weight;
    }
  }
  const auto a = make_method("tdibm-c"), b = make_method("tdibm-c");
  Ratio ratio;
  std::uint64_t pops_of_first = 0, pops_of_second = 0;
  const auto answer_all = [](Method& method, const std::vector<Query>& queries) {
    std::uint64_t pops = 0;
    for (const Query& query : queries) pops += method.answer(query, {}).pops;
    return pops;
  };
  bool weights_first = false;  // by turns: whatever else the machine does then slows both
  for ([[maybe_unused]] const auto _ : state) {
    weights_first = !weights_first;
    for (const bool with_weights : {weights_first, !weights_first}) {
      if (with_weights) {
        ratio.first([&] { pops_of_first += answer_all(**a, weighted); });
      } else {
        ratio.second([&] { pops_of_second += answer_all(**b, plain); });
      }
    }
  }
  ratio.report(state, "weights", "none");
  state.counters["pops"] = static_cast<double>(pops_of_first) / static_cast<double>(pops_of_second);
}

const bool kWeightsRegistered = [] {
  for (const ContactClass contact : kContactClasses) {
    const std::string name = fmt::format("{}/tdibm-c/weights", name_of(contact));
    benchmark::RegisterBenchmark((name + "/equal").c_str(), compare_weights, contact, 1.0)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark((name + "/rational").c_str(), compare_weights, contact,
                                 std::nextafter(1.0, 2.0))
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace ccdfuzz
