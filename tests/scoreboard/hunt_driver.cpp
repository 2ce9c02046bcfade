#include "hunt_driver.hpp"

#include <fmt/format.h>

namespace ccdfuzz {

namespace {

constexpr int kMutants = 4;  // of each method, an execution
/// Where contacts are traced, so many of a block are asked: a query takes as long as many traces.
constexpr std::uint64_t kOneAskedIn = 4;
constexpr std::uint64_t kOneBredIn = 8;

}  // namespace

HuntDriver::HuntDriver(std::uint64_t seed, const HuntParts& parts) : seed_(seed), parts_(parts) {
  if (!parts_.bred) return;
  for (const char* method : kSoundMethods) {
    HuntGround ground;
    if (std::string_view(method) == "tdibm-e") ground.scale = kErrorBoundScale;
    breeders_.emplace_back(method, seed, ground, *parts_.bred);
  }
}

std::string HuntDriver::operator()(std::uint64_t index) {
  std::string found = generate(index);
  for (Breeder& breeder : breeders_) {
    for (int i = 0; found.empty() && i < kMutants; ++i) {
      breeder.step(methods_, tracers_, kDriverSearch, [&](const Case&, const Judged& judged) {
        found = fmt::format("a mutant's answer is {}", name_of(judged.outcome));
      });
      if (breeder.tally().lost > 0) found = "a mutant's contact is lost";
    }
  }
  return found;
}

std::string HuntDriver::generate(std::uint64_t index) {
  const std::uint64_t place = index % kTracedBlock;
  if (place == 0) block_ = traced_block(seed_, index / kTracedBlock);
  const Case& known = block_.cases[place];
  Look look = parts_.look;
  if (look.traces && place % kOneAskedIn != 0) look.asks = false;
  std::string found = lost_contact(known, look, tracers_);
  if (!found.empty() || place % kOneBredIn != 0) return found;
  for (Breeder& breeder : breeders_) breeder.add(known, tracers_);
  return found;
}

}  // namespace ccdfuzz
