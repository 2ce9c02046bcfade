// Whole queries with a known contact: the witness is traced through the methods that are proven to
// lose none, which must not, and through one of the others, which the bytes choose. The bytes are a
// case (fuzz/mutator/case_bytes.hpp); mutants keep their contact exactly, and how nearly each
// method lost it guides libFuzzer.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <string_view>

#include "case/case_json.hpp"
#include "ccd/witness_trace/loss_signature.hpp"
#include "fuzz/lost_inputs.hpp"
#include "fuzz/margins.hpp"
#include "fuzz/mutating.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "method/by_spec.hpp"

namespace {

using namespace ccdfuzz;  // NOLINT: a target is a file of its own

struct Traced {
  const char* method;
  bool is_sound;  ///< proven to lose no contact
};

/// Those that are sound look at every input, and one of the others, which are ten times as slow.
constexpr std::size_t kSound = 2;
constexpr std::array kTraced = {
    Traced{"tdibm-c", true},        Traced{"tdibm-rational", true},
    Traced{"tdibm", false},         Traced{"tdibm-h:1e-16", false},
    Traced{"tdibm-h:1e-12", false}, Traced{"tdibm-h:1e-12@absolute", false},
    Traced{"tdibm-e", false},       Traced{"tdibm-e-literal", false},
    Traced{"trad", false}};
static_assert(kTraced.size() <= Margins::kMethods);

/// CCDFUZZ_TRACED_METHOD names the one method to be traced, for comparison
/// (bench/fuzz_guidance.sh).
const char* method_traced_alone() {
  const char* const name = std::getenv("CCDFUZZ_TRACED_METHOD");
  const auto is_it = [&](const Traced& traced) { return std::string_view(traced.method) == name; };
  if (name == nullptr || std::ranges::any_of(kTraced, is_it)) return name;
  std::cerr << "CCDFUZZ_TRACED_METHOD: " << name << " is none of the methods traced\n";
  std::_Exit(2);  // std::exit, libFuzzer would call a crash of this input
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  return mutate_case(data, size, max_size, seed, 8);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static TracerSet tracers;
  static LostInputs lost_inputs;
  static const char* const alone = method_traced_alone();
  const auto q = contact_of_bytes(std::span(data, size));
  if (!q) return -1;  // not for the corpus
  const Witness witness = q->witness();
  const std::size_t sum = std::accumulate(data, data + size, std::size_t{0});
  const std::size_t other = kSound + sum % (kTraced.size() - kSound);
  for (std::size_t m = 0; m < kTraced.size(); ++m) {
    const bool is_due =
        alone != nullptr ? std::string_view(kTraced[m].method) == alone : m < kSound || m == other;
    if (!is_due) continue;
    const Trace& trace = tracers[kTraced[m].method].trace(q->query, witness, {});
    Margins::note(m, trace);
    if (!trace.lost) continue;
    if (!kTraced[m].is_sound) {
      lost_inputs.keep({data, size},
                       fmt::format("{} {} {}", kTraced[m].method, name_of(contact_class_of(*q)),
                                   loss_signature(trace)));
      continue;
    }
    std::cerr << kTraced[m].method << " loses the contact of this case; show it with"
              << " `ccdfuzz trace CASE.json`:\n"
              << to_json(case_of(*q)) << '\n';
    std::abort();
  }
  return 0;
}
