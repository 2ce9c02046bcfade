// What weights and a separation cost tdibm-c: the same queries with them and without, of nearly the
// same answers.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "generators/generate.hpp"
#include "io/cpu_time.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

constexpr std::uint64_t kOfEachKind = 8;
/// So small that contacts stay where they are: patches measure about 1.
constexpr double kSeparation = 0x1p-100;

/// Generated queries of a contact class: up to t*, and up to t* − 2^-20.
std::vector<Query> generated_queries(ContactClass contact) {
  std::vector<Query> all;
  for (std::uint64_t i = 0; i < kOfEachKind; ++i) {
    for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
      const GeneratorOptions options = {
          .contact = contact, .kind = kind, .construction = Construction::kOneSided, .seed = 1};
      all.push_back(generate(options, i).value.query);
    }
  }
  return all;
}

void add_weights(Query* query, double first_weight) {
  for (MovingPatch<double>& patch : query->patches) {
    patch.weights.assign(patch.positions.size(), 1);
    patch.weights[0] = first_weight;
  }
}

struct Feature {
  const char* name;
  void (*add)(Query* query);
};

constexpr Feature kFeatures[] = {
    {"equal_weights", [](Query* query) { add_weights(query, 1); }},
    // Nearly the same patches, which the rational arithmetic searches.
    {"rational", [](Query* query) { add_weights(query, std::nextafter(1.0, 2.0)); }},
    {"separation", [](Query* query) { query->separation = kSeparation; }},
};

void compare(benchmark::State& state, ContactClass contact, const Feature& feature) {
  std::vector<Query> featured = generated_queries(contact);
  const std::vector<Query> plain = featured;
  for (Query& query : featured) feature.add(&query);
  // One method answers both: where a second one's memory lies is worth up to 7 % of a VV query.
  const auto method = make_method("tdibm-c");
  const auto answer_all = [&](const std::vector<Query>& queries) {
    std::uint64_t pops = 0;
    for (const Query& query : queries) pops += (*method)->answer(query, {}).pops;
    return pops;
  };
  struct {
    double seconds = 0;  // CPU
    std::uint64_t pops = 0;
  } with, without;
  bool feature_first = false;  // by turns: whatever else the machine does then slows both
  for ([[maybe_unused]] const auto _ : state) {
    feature_first = !feature_first;
    for (const bool with_feature : {feature_first, !feature_first}) {
      auto& cost = with_feature ? with : without;
      const double begin = thread_cpu_seconds();
      cost.pops += answer_all(with_feature ? featured : plain);
      cost.seconds += thread_cpu_seconds() - begin;
    }
  }
  const auto rounds = static_cast<double>(state.iterations());
  state.counters[feature.name] = with.seconds / rounds;
  state.counters["none"] = without.seconds / rounds;
  state.counters["ratio"] = with.seconds / without.seconds;
  state.counters["pops"] = static_cast<double>(with.pops) / static_cast<double>(without.pops);
}

const bool kFeaturesRegistered = [] {
  for (const Feature& feature : kFeatures) {
    for (const ContactClass contact : kContactClasses) {
      const std::string name = fmt::format("{}/tdibm-c/{}", name_of(contact), feature.name);
      benchmark::RegisterBenchmark(name.c_str(), compare, contact, feature)
          ->Unit(benchmark::kMillisecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace ccdfuzz
