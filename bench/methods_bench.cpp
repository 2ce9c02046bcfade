// tdibm-c against the methods of the paper, its forms as written, and the exact one, on generated
// cases of each contact class: positives up to t* and negatives up to t* − 2^-20.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/ratio.hpp"
#include "generators/generate.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

constexpr std::uint64_t kQueryCases = 4;
/// trad takes minutes where patches are nearly parallel: its time is a lower bound.
constexpr std::uint64_t kPopsOfTrad = 2'000;

std::vector<Query> queries(ContactClass contact) {
  std::vector<Query> all;
  for (std::uint64_t i = 0; i < kQueryCases; ++i) {
    for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
      GeneratorOptions options;
      options.contact = contact;
      options.kind = kind;
      options.construction = Construction::kOneSided;
      options.seed = 1;
      all.push_back(generate(options, i).value.query);
    }
  }
  return all;
}

void compare_queries(benchmark::State& state, ContactClass contact, const char* first,
                     const char* second) {
  const auto a = make_method(first), b = make_method(second);
  const std::vector<Query> all = queries(contact);
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
