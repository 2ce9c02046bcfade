// The libFuzzer target of the claim about the checker alone. It is linked with nothing but the
// checker and what is drawn, so that a fault elsewhere cannot hide one of the checker.
#include "properties/checker_alone.hpp"

#include <cstdio>
#include <cstdlib>
#include <span>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ccdfuzz;  // NOLINT: of this function alone
  static const Property claim = checker_alone_claims().at(0);
  const std::span<const std::uint8_t> bytes(data, size);
  Draw choices = Draw::from_numbers(ChoiceNumbers(bytes.begin(), bytes.end()));
  const Check check = run(claim, choices);
  if (check.status != Check::Status::kFails) return 0;
  std::fprintf(stderr, "refuted claim: %s fails: %s\n", claim.name.c_str(), check.text.c_str());
  std::abort();
}
