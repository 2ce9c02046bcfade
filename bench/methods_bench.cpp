// The methods against each other on generated cases of each contact class: the paper's
// error-bounded TDIBM over the plain, the certified and the exact one.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "bench/ratio.hpp"
#include "generators/generate.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

constexpr std::uint64_t kCases = 4;

std::vector<Query> queries(ContactClass contact) {
  GeneratorOptions options;
  options.contact = contact;
  options.kind = CaseKind::kRN;  // the costly kind: there is no contact to stop at
  options.construction = Construction::kOneSided;
  options.seed = 1;
  std::vector<Query> all;
  for (std::uint64_t i = 0; i < kCases; ++i) all.push_back(generate(options, i).value.query);
  return all;
}

void compare(benchmark::State& state, ContactClass contact, const char* first, const char* second) {
  const auto a = make_method(first), b = make_method(second);
  const std::vector<Query> all = queries(contact);
  const SearchOptions options;
  Ratio ratio;
  for ([[maybe_unused]] const auto _ : state) {
    for (const Query& query : all) {
      ratio.first([&] { benchmark::DoNotOptimize((*a)->answer(query, options)); });
      ratio.second([&] { benchmark::DoNotOptimize((*b)->answer(query, options)); });
    }
  }
  ratio.report(state, first, second);
}

const bool kRegistered = [] {
  for (const ContactClass contact : kContactClasses) {
    for (const char* other : {"tdibm", "tdibm-c", "tdibm-rational"}) {
      benchmark::RegisterBenchmark(fmt::format("{}/tdibm-e:{}", name_of(contact), other).c_str(),
                                   compare, contact, "tdibm-e", other)
          ->Unit(benchmark::kMillisecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace ccdfuzz
