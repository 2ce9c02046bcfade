#include "hunt_driver.hpp"

#include <fmt/format.h>

#include "case/judge.hpp"
#include "eval/horizons.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

namespace {

constexpr int kMutants = 4;  // of each method, an execution
/// Where contacts are traced, one in this many is asked: a query takes as long as many traces.
constexpr std::uint64_t kOneAskedIn = 4;
/// One in this many is bred, the first of those that are of one class.
constexpr std::uint64_t kOneBredIn = 8;

/// A contact in any scale and place, asked up to it or past it.
Case contact_anywhere(std::uint64_t seed, std::uint64_t index) {
  const std::uint64_t round = index / kOneBredIn;
  GeneratorOptions options;
  options.family = Family::kAnywhere;
  options.contact = kContactClasses[round % kContactClasses.size()];
  options.seed = seed;
  const Case known = generate(options, index).value;
  const double factor = kHorizonFactors[round / kContactClasses.size() % kHorizonFactors.size()];
  const std::optional<double> t_max = horizon_of(known, factor);
  return t_max ? with_t_max(known, *t_max) : known;
}

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
      breeder.step(methods_, kDriverSearch, [&](const Case&, const Judged& judged) {
        found = fmt::format("a mutant's answer is {}", name_of(judged.outcome));
      });
      if (breeder.tally().lost > 0) found = "a mutant's contact is lost";
    }
  }
  return found;
}

std::string HuntDriver::generate(std::uint64_t index) {
  const Case known = contact_anywhere(seed_, index);
  Look look = parts_.look;
  if (look.traces && index % kOneAskedIn != 0) look.asks = false;
  std::string found = lost_contact(known, look, methods_);
  if (!found.empty() || index % kOneBredIn != 0) return found;
  for (Breeder& breeder : breeders_) breeder.add(known, methods_);
  return found;
}

}  // namespace ccdfuzz
