// Mutants a second: made, traced and by that judged, of triangular quadratic contacts of a class.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <vector>

#include "ccd/witness_trace/trace.hpp"
#include "fuzz/mutator/mutate.hpp"
#include "generators/generate.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

std::vector<Contact> mutant_bases(ContactClass contact) {
  constexpr std::uint64_t kBases = 32;
  std::vector<Contact> bases;
  for (std::uint64_t i = 0; i < kBases; ++i) {
    const GeneratorOptions options = {
        .contact = contact,
        .construction = i % 2 == 0 ? Construction::kOneSided : Construction::kPaper,
        .seed = 1};
    if (auto q = contact_of(generate(options, i).value)) bases.push_back(*std::move(q));
  }
  return bases;
}

/// spec: empty to make mutants and do nothing with them.
void make_mutants(benchmark::State& state, ContactClass contact, const std::string& spec) {
  const std::vector<Contact> bases = mutant_bases(contact);
  const auto method = make_method(spec.empty() ? "tdibm-c" : spec);
  Draw random{Random(1)};
  std::int64_t lost = 0;
  for ([[maybe_unused]] const auto _ : state) {
    const Contact& mother = bases[random.below(bases.size())];
    const Contact& father = bases[random.below(bases.size())];
    const Contact mutant = mutate(mother, father, random);
    if (spec.empty()) {
      benchmark::DoNotOptimize(mutant.query.t_max);
    } else {
      lost += (*method)->trace(mutant.query, mutant.witness(), {}).lost ? 1 : 0;
    }
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["lost"] = static_cast<double>(lost);
}

const bool kMutantsRegistered = [] {
  for (const ContactClass contact : {ContactClass::kFF, ContactClass::kVV}) {
    for (const char* spec :
         {"", "tdibm-c", "tdibm", "tdibm-h:1e-12", "tdibm-e", "tdibm-rational"}) {
      const std::string what = *spec == '\0' ? "made" : spec;
      const std::string name = fmt::format("{}/mutants/{}", name_of(contact), what);
      benchmark::RegisterBenchmark(name.c_str(), make_mutants, contact, std::string(spec));
    }
  }
  return true;
}();

}  // namespace
}  // namespace ccdfuzz
