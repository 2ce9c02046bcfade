#include "drivers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "fuzz_drivers.hpp"
#include "hunt/breeder.hpp"
#include "hunt/traced_cases.hpp"
#include "properties/envelope.hpp"
#include "properties/registry.hpp"
#include "property_turns.hpp"
#include "rapidcheck.hpp"
#include "sound.hpp"

namespace ccdfuzz {

namespace {

/// One execution: what is wrong, or nothing.
using Step = std::function<std::string(std::uint64_t index)>;

/// Two triangles of degree 2 whose numbers come from `number`.
Query random_query(const std::function<double()>& number) {
  Query query;
  for (MovingPatch<double>& patch : query.patches) {
    patch.shape = Shape::triangle(2);
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      for (int i = 0; i < patch.shape.control_count(); ++i) {
        const double x = number(), y = number(), z = number();
        points->push_back({x, y, z});
      }
    }
  }
  return query;
}

Step random_driver(std::uint64_t seed) {
  return [seed](std::uint64_t index) {
    Random random = Random::keyed({seed, index});
    return contradiction(random_query([&] {
      return std::ldexp(static_cast<double>(random.between(-(1L << 52), 1L << 52)), -52);
    }));
  };
}

Step rapidcheck_driver(std::uint64_t seed) {
  return [seed](std::uint64_t index) -> std::string {
    constexpr int kSize = 100;
    rc::Random random(Random::keyed({seed, index}).next());
    const auto number = [&] { return rc::gen::arbitrary<double>()(random.split(), kSize).value(); };
    if (index % 2 == 0) return contradiction(random_query(number));
    LinePairs pairs;
    for (auto* lines : {&pairs.f, &pairs.g}) {
      for (int i = 0; i < 5; ++i) {
        const double slope = number(), intercept = number();
        lines->push_back({slope, intercept});
      }
    }
    pairs.window = {0, std::abs(number())};
    const ErrorBoundIntended policy;
    Check check = envelope_is_never_below_the_maximum(policy, pairs.f, pairs.window);
    if (check.status != Check::Status::kFails) check = separation_is_true(policy, pairs);
    return check.status == Check::Status::kFails ? check.text : "";
  };
}

/// By turns a generated contact, and mutants of those that there were, bred towards what one of the
/// methods nearly loses. One case of a block in four is asked too.
class Hunt {
 public:
  explicit Hunt(std::uint64_t seed) : seed_(seed) {
    for (const char* method : kSoundMethods) {
      const bool bounded = std::string_view(method) == "tdibm-e";
      breeders_.emplace_back(method, seed,
                             bounded ? std::optional<int>(kErrorBoundScale) : std::nullopt);
    }
  }

  std::string operator()(std::uint64_t index) {
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

 private:
  static constexpr int kMutants = 4;

  std::string generate(std::uint64_t index) {
    const std::uint64_t place = index % kTracedBlock;
    if (place == 0) block_ = traced_block(seed_, index / kTracedBlock);
    const Case& known = block_.cases[place];
    std::string found = lost_contact(known, place % 4 == 0, tracers_);
    if (!found.empty() || place % 8 != 0) return found;
    for (Breeder& breeder : breeders_) breeder.add(known, tracers_);
    return found;
  }

  std::uint64_t seed_;
  TracedBlock block_;
  MethodSet methods_;
  TracerSet tracers_;
  std::vector<Breeder> breeders_;
};

Step step_of(Driver driver, std::uint64_t seed) {
  switch (driver) {
    case Driver::kRandom:
      return random_driver(seed);
    case Driver::kRapidCheck:
      return rapidcheck_driver(seed);
    case Driver::kProperties:
      return [turns = std::make_shared<PropertyTurns>(properties(), seed)](std::uint64_t) {
        return (*turns)();
      };
    case Driver::kHunt:
      return [hunt = std::make_shared<Hunt>(seed)](std::uint64_t index) { return (*hunt)(index); };
    case Driver::kRawFuzzer:
    case Driver::kFuzzer:
      break;
  }
  return {};
}

}  // namespace

std::string_view name_of(Driver driver) {
  constexpr std::array<std::string_view, kDrivers.size()> kNames = {
      "random", "rapidcheck", "libfuzzer-raw", "libfuzzer", "properties", "hunt"};
  return kNames[static_cast<std::size_t>(driver)];
}

bool is_built(Driver driver) {
  return kHasFuzzer || (driver != Driver::kRawFuzzer && driver != Driver::kFuzzer);
}

void drive(Driver driver, std::uint64_t seed, const DriveLimit& limit,
           const std::function<void(const DriverRun&)>& done) {
  if (driver == Driver::kRawFuzzer || driver == Driver::kFuzzer) {
    drive_fuzzer(driver, seed, limit, done);
  }
  const double end = cpu_seconds_used() + limit.cpu_seconds;
  const Step step = step_of(driver, seed);
  DriverRun run;
  Heartbeat heart;
  while (run.found.empty() && run.executions < limit.executions && cpu_seconds_used() < end) {
    heart.beat();
    try {
      run.found = step(run.executions);
    } catch (const std::exception& error) {
      run.found = std::string("an exception: ") + error.what();
    }
    ++run.executions;
  }
  done(run);
  std::abort();
}

}  // namespace ccdfuzz
