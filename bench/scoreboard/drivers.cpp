#include "drivers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "corpus_driver.hpp"
#include "hunt_driver.hpp"
#include "properties/envelope.hpp"
#include "properties/suites.hpp"
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
    patch.positions.resize(6);
    patch.velocities.resize(6);
    for_each_coordinate(patch, [&](double& x) { x = number(); });
  }
  return query;
}

Step random_driver(std::uint64_t seed) {
  return [seed](std::uint64_t index) {
    Draw random{Random::keyed({seed, index})};
    return contradiction(random_query([&] {
      return std::ldexp(static_cast<double>(random.integer(-(1L << 52), 1L << 52)), -52);
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
    try {
      claim_envelope_is_never_below<ErrorBoundIntended>(pairs.f, pairs.window);
      claim_separation_is_true<ErrorBoundIntended>(pairs);
    } catch (const Refuted& failure) {
      return failure.what();
    }
    return "";
  };
}

/// What of a hunt a driver is, if it is one.
std::optional<HuntParts> hunt_parts(Driver driver) {
  switch (driver) {
    case Driver::kContacts:
      return HuntParts{{.traces = false}, {}};
    case Driver::kTraces:
      return HuntParts{{.asks = false}, {}};
    case Driver::kChance:
      return HuntParts{{}, Aim::kNothing};
    case Driver::kHunt:
      return HuntParts{{}, Aim::kMargins};
    default:
      return {};
  }
}

/// What a driver does, and how many times, if there is an end to it.
struct DriverWork {
  Step step;
  std::uint64_t size = std::numeric_limits<std::uint64_t>::max();
};

DriverWork work_of(Driver driver, std::uint64_t seed) {
  if (const auto parts = hunt_parts(driver)) {
    return {[hunt = std::make_shared<HuntDriver>(seed, *parts)](std::uint64_t index) {
      return (*hunt)(index);
    }};
  }
  switch (driver) {
    case Driver::kRandom:
      return {random_driver(seed)};
    case Driver::kRapidCheck:
      return {rapidcheck_driver(seed)};
    case Driver::kProperties:
      return {[turns = std::make_shared<PropertyTurns>(properties(), seed)](std::uint64_t) {
        return (*turns)();
      }};
    case Driver::kCorpus: {
      const auto corpus = std::make_shared<CorpusDriver>(CCDFUZZ_CORPUS);
      return {[corpus](std::uint64_t index) { return (*corpus)(index); }, corpus->size()};
    }
    default:
      return {};
  }
}

}  // namespace

void drive(Driver driver, std::uint64_t seed, const DriveLimit& limit,
           const std::function<void(const DriverRun&)>& done) {
  const double end = cpu_seconds_used() + limit.cpu_seconds;
  const DriverWork work = work_of(driver, seed);
  const std::uint64_t most = std::min(limit.executions, work.size);
  DriverRun run;
  Heartbeat heart;
  while (run.found.empty() && run.executions < most && cpu_seconds_used() < end) {
    heart.beat();
    try {
      run.found = work.step(run.executions);
    } catch (const std::exception& error) {
      run.found = std::string("an exception: ") + error.what();
    }
    ++run.executions;
  }
  done(run);
  std::abort();
}

}  // namespace ccdfuzz
