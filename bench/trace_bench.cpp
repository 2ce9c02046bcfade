// A full query over a trace of its witness, of the same method on the same positive cases.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "bench/ratio.hpp"
#include "ccd/witness_trace/trace.hpp"
#include "generators/generate.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

constexpr std::uint64_t kTraceCases = 8;

void compare_traces(benchmark::State& state, ContactClass contact, const char* spec) {
  const auto method = make_method(spec);
  GeneratorOptions generator;
  generator.contact = contact;
  generator.construction = Construction::kOneSided;
  generator.seed = 1;
  std::vector<Case> cases;
  for (std::uint64_t i = 0; i < kTraceCases; ++i) cases.push_back(generate(generator, i).value);
  const auto trace = [&](const Case& known) {
    benchmark::DoNotOptimize((*method)->trace(known.query, *known.truth.witness, {}).lost);
  };
  for (const Case& known : cases) trace(known);  // warm
  Ratio ratio;
  for ([[maybe_unused]] const auto _ : state) {
    for (const Case& known : cases) {
      ratio.first([&] { benchmark::DoNotOptimize((*method)->answer(known.query, {})); });
      ratio.second([&] { trace(known); });
    }
  }
  ratio.report(state, "query", "trace");
}

const bool kTracesRegistered = [] {
  for (const ContactClass contact : kContactClasses) {
    for (const char* spec : {"tdibm", "tdibm-e", "tdibm-rational", "tdibm-c"}) {
      const std::string name = fmt::format("{}/{}/query:trace", name_of(contact), spec);
      benchmark::RegisterBenchmark(name.c_str(), compare_traces, contact, spec)
          ->Unit(benchmark::kMillisecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace ccdfuzz
