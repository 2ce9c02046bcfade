#include "fuzz/target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "base/text.hpp"
#include "fuzz/mutator/libfuzzer.hpp"
#include "generators/draw/choice_bytes.hpp"
#include "generators/draw/mutate_choices.hpp"
#include "properties/claim_input.hpp"

namespace ccdfuzz {

namespace {

const Suite& this_suite() {
  static const Suite suite = suite_named(kSuite).value();
  return suite;
}

/// The command that runs one input of one property again.
std::string check_command() {
#ifdef CCDFUZZ_PROGRAM
  return shell_word(CCDFUZZ_PROGRAM) + " check";
#else  // built for an engine, to run on another machine
  return "ccdfuzz check";
#endif
}

std::size_t put(const ClaimInput& input, std::uint8_t* data, std::size_t max_size) {
  const std::vector<std::uint8_t> bytes = to_bytes(input);
  const std::size_t size = std::min(bytes.size(), max_size);
  std::copy_n(bytes.begin(), size, data);
  return size;
}

ClaimInput drawn_input(Draw& random) {
  static const std::vector<Property> claims = this_suite().thought_to_hold();
  const Property& claim = claims[random.below(claims.size())];
  return {claim, drawn_choices(random)};
}

std::size_t mutated_bytes(std::uint8_t* data, std::size_t size, std::size_t max_size,
                          unsigned seed) {
  // Draws kill twice as many planted faults in 5 s as coverage does (bench/scoreboard), which goes
  // on from what they reach: an equal share for either.
  constexpr std::uint64_t kOneDrawnIn = 2;
  Draw random{Random(seed)};
  if (this_suite().is_of_bytes) {
    return LLVMFuzzerMutate != nullptr ? LLVMFuzzerMutate(data, size, max_size) : size;
  }
  auto input = claim_input(this_suite(), {data, size});
  if (!input || random.below(kOneDrawnIn) == 0) return put(drawn_input(random), data, max_size);
  input->choices = mutated(std::move(input->choices), random);
  return put(*input, data, max_size);
}

}  // namespace

}  // namespace ccdfuzz

/// Checks one of the suite's claims on the bytes (claim_input). A failure is printed with its
/// operands and ends the process, so that libFuzzer keeps the input. The first line names the
/// claim: by such a line ClusterFuzz tells failures apart.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ccdfuzz;  // NOLINT: of this function alone
  const auto input = claim_input(this_suite(), {data, size});
  if (!input) return -1;  // not for the corpus
  Draw choices = Draw::from_numbers(input->choices);
  const Check check = run(input->property, choices);
  if (check.status == Check::Status::kDiscarded) return -1;
  if (check.status == Check::Status::kFails) {
    std::cerr << fmt::format("Assertion failed: {}\n{}\nreproduce: {} {} --choices {}\n",
                             input->property.name, check.text, check_command(),
                             input->property.name, to_word(choices.numbers()));
    std::abort();
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  return ccdfuzz::mutated_bytes(data, size, max_size, seed);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1,
                                                 const std::uint8_t* data2, std::size_t size2,
                                                 std::uint8_t* out, std::size_t max_size,
                                                 unsigned int seed) {
  using namespace ccdfuzz;  // NOLINT: of this function alone
  Draw random{Random(seed)};
  auto mother = claim_input(this_suite(), {data1, size1});
  const auto father = claim_input(this_suite(), {data2, size2});
  if (!mother || !father || this_suite().is_of_bytes) return 0;
  mother->choices = crossed(mother->choices, father->choices, random);
  return put(*mother, out, max_size);
}
