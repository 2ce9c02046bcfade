// Any queries: contacts, near-misses, and numbers without sense. The oracle decides each, the
// checker checks what it says, and the methods are judged by it. Those that are proven to miss
// nothing must not miss; of the others the one is judged that the input names. The bytes are a
// method and a case (fuzz/mutator/case_bytes.hpp), whose contact may be broken.
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <iostream>

#include "fuzz/lost_inputs.hpp"
#include "fuzz/mutator/mutate.hpp"
#include "fuzz/unproven.hpp"
#include "method/method_set.hpp"
#include "properties/against_oracle.hpp"

namespace {

using namespace ccdfuzz;  // NOLINT: a target is a file of its own

constexpr SearchOptions kFine = {SearchOptions().precision, 100, 16 << 20};
/// Larger patches take the exact method seconds.
constexpr int kMostControls = 24;

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  return mutate_case(data, size, max_size, seed,
                     {.own_in = 2, .methods = kUnproven.size(), .range = QueryRange::kAll});
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static MethodSet methods;
  static LostInputs lost_inputs;
  const auto query = query_of(std::span(data, size));
  if (!query) return -1;  // not for the corpus
  const std::array<Shape, 2> shapes = {query->patches[0].shape, query->patches[1].shape};
  if (shapes[0].control_count() + shapes[1].control_count() > kMostControls) return -1;
  Case known;
  try {
    known = decide_briefly(*query, kRefutationPops);
    if (known.truth.collides != true) return 0;
    for (const std::string& name : miss_nothing()) {
      claim_not_contradicted(name, methods[name], known, kRefutationSearch);
    }
  } catch (const Refuted& why) {
    std::cerr << "Assertion failed: " << why.what() << "\nshow it with `ccdfuzz query CASE.json`\n";
    std::abort();
  }
  const char* const unproven = kUnproven[unproven_of({data, size})];
  if (is_false_negative(outcome_on(methods[unproven], known, kFine))) {
    lost_inputs.keep({data, size},
                     fmt::format("{} {} {}", unproven, to_text(shapes[0]), to_text(shapes[1])));
  }
  return 0;
}
