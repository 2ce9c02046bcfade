// `claim_inputs SUITE FOLDER CORPUS` writes seeds of the suite's fuzz target, with any compiler.
// Each claim that is thought to hold gets an input, as `ccdfuzz check` draws it. The exit code is 1
// where one gets none. Entries of corpus/claims are inputs of their claims. One of a claim that is
// known to be false is an input of each other claim of the suite that does not discard it. What
// is expected to fail a claim that is thought to hold is none: the target would end on it.
#include <fmt/format.h>

#include <iostream>
#include <optional>
#include <set>

#include "finds/claim_files.hpp"
#include "io/hash_name.hpp"
#include "io/output_file.hpp"
#include "properties/claim_input.hpp"

namespace ccdfuzz {
namespace {

/// A claim discards a draw now and then. Most discard none of these, and none all.
constexpr std::uint64_t kMostDraws = 100;

/// The choices that a claim makes of these, as an input of its target. None if it discards them, in
/// that form too: an input of bytes has no larger choices.
std::optional<std::string> input_of(const Suite& suite, const Property& claim, Draw choices) {
  if (run(claim, choices, false).status == Check::Status::kDiscarded) return std::nullopt;
  const ChoiceNumbers& made = choices.numbers();
  const std::vector<std::uint8_t> bytes = suite.is_of_bytes
                                              ? std::vector<std::uint8_t>(made.begin(), made.end())
                                              : to_bytes({claim, made});
  Draw again = Draw::from_numbers(claim_input(suite, bytes).value().choices);
  if (run(claim, again, false).status == Check::Status::kDiscarded) return std::nullopt;
  return std::string(bytes.begin(), bytes.end());
}

/// One for each of many claims, and several for the one of a suite of bytes.
std::vector<std::string> drawn_inputs(const Suite& suite, const Property& claim) {
  const std::size_t wanted = suite.is_of_bytes ? 16 : 1;
  std::vector<std::string> inputs;
  for (std::uint64_t i = 0; i < kMostDraws && inputs.size() < wanted; ++i) {
    auto input = input_of(suite, claim, Draw::mostly_small(Random::keyed({1, i})));
    if (input) inputs.push_back(*std::move(input));
  }
  return inputs;
}

/// Errors: of the corpus or the folder; a claim of which no draw is an input.
Result<std::string> encode(const std::string& name, const std::string& folder,
                           const std::string& corpus) {
  CCDFUZZ_TRY(const Suite suite, suite_named(name));
  CCDFUZZ_TRY(const CorpusFiles files, cases_and_claims(corpus));
  std::vector<ClaimFind> kept;
  for (const std::string& path : files.claims) {
    CCDFUZZ_TRY(kept.emplace_back(), read_claim(path));
  }
  CCDFUZZ_TRY_VOID(make_folder(folder));
  std::set<std::string> written;  // two entries may be one input of another claim
  const auto write = [&](const Property& claim, const std::string& input) {
    const std::string file = fmt::format("{}-{}", claim.name, hash_name(input));
    written.insert(file);
    return write_file(fmt::format("{}/{}", folder, file), input);
  };
  const std::vector<Property> claims = suite.thought_to_hold();
  for (const Property& claim : claims) {
    const auto drawn = drawn_inputs(suite, claim);
    if (drawn.empty()) return input_error(claim.name, "discards all that is drawn");
    for (const std::string& input : drawn) CCDFUZZ_TRY_VOID(write(claim, input));
    for (const ClaimFind& entry : kept) {
      const auto is_of_suite = property_named(entry.property, suite.claims);
      if (!is_of_suite || suite.is_of_bytes) continue;
      const bool fails = entry.expect == Check::Status::kFails;
      if (is_of_suite->expected == Expectation::kHolds && (entry.property != claim.name || fails)) {
        continue;
      }
      const auto input = input_of(suite, claim, Draw::from_numbers(entry.choices));
      if (input) CCDFUZZ_TRY_VOID(write(claim, *input));
    }
  }
  return fmt::format("{} seeds of {} claims in {}", written.size(), claims.size(), folder);
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  using namespace ccdfuzz;  // NOLINT: the program's own
  const std::vector<std::string> words(argv + 1, argv + argc);
  const auto done = words.size() == 3 ? encode(words[0], words[1], words[2])
                                      : input_error("", "say: SUITE FOLDER CORPUS");
  (done ? std::cout : std::cerr) << (done ? *done : "claim inputs: " + done.error().message())
                                 << '\n';
  return done ? 0 : 1;
}
