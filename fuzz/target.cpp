#include "fuzz/target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <vector>

#include "base/text.hpp"
#include "fuzz/libfuzzer.hpp"
#include "properties/claim_input.hpp"

namespace ccdfuzz {

namespace {

const Suite& this_suite() {
  static const Suite suite = suite_named(kSuite).value();
  return suite;
}

/// What runs one input of one property again.
std::string check_command() {
#ifdef CCDFUZZ_CHECK_PROPERTY
  return shell_word(CCDFUZZ_CHECK_PROPERTY);
#else  // built for an engine, to run on another machine
  return "ccdfuzz check";
#endif
}

/// Whether an input was run to its end. libFuzzer runs each before it mutates it, but for one that
/// it minimises, which does not end.
bool any_ended = false;

std::size_t mutated(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
  // Draws kill twice as many planted faults in 5 s as coverage does (tests/scoreboard), which goes
  // on from what they reach: an equal share for either.
  constexpr std::uint64_t kOneDrawnIn = 2;
  const Suite& suite = this_suite();
  Draw random{Random(seed)};
  if (!suite.reads_text) {
    const auto take = [&](const std::vector<std::uint8_t>& input) {
      size = std::min(input.size(), max_size);
      std::copy_n(input.begin(), size, data);
    };
    if (random.below(kOneDrawnIn) == 0) {
      take(drawn_input(random));
      return size;
    }
    if (any_ended) {
      if (const auto bytes = drawn_as_bytes(suite, {data, size})) take(*bytes);
    }
  }
  return LLVMFuzzerMutate != nullptr ? LLVMFuzzerMutate(data, size, max_size) : size;
}

}  // namespace

int check_input(std::span<const std::uint8_t> bytes) {
  const Suite& suite = this_suite();
  const auto input = claim_input(suite, bytes);
  if (!input) return -1;  // not for the corpus
  Draw choices = input->choices();
  const Check check = run(input->property, choices);
  any_ended = true;
  if (check.status == Check::Status::kDiscarded) return -1;
  if (check.status == Check::Status::kFails) {
    std::cerr << fmt::format("refuted claim: {} fails: {}\nreproduce: {} {} --hex {}\n",
                             input->property.name, check.text, check_command(),
                             input->property.name, to_hex_word(choices.bytes()));
    std::abort();
  }
  return 0;
}

}  // namespace ccdfuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  return ccdfuzz::mutated(data, size, max_size, seed);
}
