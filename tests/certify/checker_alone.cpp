// The checker by itself, linked with nothing that reads files, writes or asks methods. Exits 1 on a
// contradiction, on a refusal of what is true, and where a kind of certificate was accepted never.
//   checker_alone [SEED [INPUTS]]
#include "properties/checker_alone.hpp"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  using namespace ccdfuzz;  // NOLINT: the program's own
  const std::uint64_t seed = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1;
  const std::uint64_t inputs = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 5000;
  const Property claim = checker_alone_claims().at(0);
  std::array<std::uint64_t, kDrawnCertificates.size()> counts{};
  Property counting = claim;
  counting.check = [&](Draw& d) {
    const AcceptedCertificates accepted = hold_certificates(d);
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += accepted[i] ? 1 : 0;
  };
  for (std::uint64_t i = 0; i < inputs; ++i) {
    Draw choices(Random::keyed({seed, i}));
    choices.record();
    const Check check = run(counting, choices);
    if (check.status != Check::Status::kFails) continue;
    std::printf("%s\n", check.text.c_str());
    return EXIT_FAILURE;
  }
  int status = EXIT_SUCCESS;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    std::printf("%c %llu\n", kDrawnCertificates[i], static_cast<unsigned long long>(counts[i]));
    if (counts[i] == 0) status = EXIT_FAILURE;
  }
  return status;
}
