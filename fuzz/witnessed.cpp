// Queries with a known contact, whose witness is traced. The methods that are proven to lose none
// must not lose it. One of the others is traced as well, which the input names. The bytes are a
// method and a case (fuzz/mutator/case_bytes.hpp). Mutants keep their contact exactly, and mostly
// their method, so that what they cover of it guides libFuzzer.
#include <fmt/format.h>

#include <cstdlib>
#include <iostream>

#include "ccd/witness_trace/loss_signature.hpp"
#include "files/case_json.hpp"
#include "fuzz/lost_inputs.hpp"
#include "fuzz/mutator/mutate.hpp"
#include "fuzz/unproven.hpp"
#include "method/method_set.hpp"
#include "properties/against_oracle.hpp"

namespace {

using namespace ccdfuzz;  // NOLINT: a target is a file of its own

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  return mutate_case(data, size, max_size, seed,
                     {.own_in = 8, .methods = kUnproven.size(), .range = QueryRange::kAll});
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static MethodSet methods;
  static LostInputs lost_inputs;
  const auto q = contact_of_bytes(std::span(data, size), QueryRange::kAll);
  if (!q) return -1;  // not for the corpus
  const Witness witness = q->witness();
  for (const std::string& sound : miss_nothing()) {
    const Trace& trace = methods[sound].trace(q->query, witness, {});
    if (!trace.lost) continue;
    std::cerr << "Assertion failed: " << sound << " loses the contact of this case; show it with"
              << " `ccdfuzz trace CASE.json`:\n"
              << to_json(case_of(*q)) << '\n';
    std::abort();
  }
  const std::size_t place = unproven_of({data, size});
  if (!check_taken(kUnproven[place], q->query)) return 0;
  const Trace& trace = methods[kUnproven[place]].trace(q->query, witness, {});
  if (trace.lost) {
    lost_inputs.keep({data, size},
                     fmt::format("{} {} {}", kUnproven[place], name_of(contact_class_of(*q)),
                                 loss_signature(trace)));
  }
  return 0;
}
