#include "drivers.hpp"

#include <fmt/format.h>

#include <ctime>
#include <functional>

#include "certify/checker/check_truth.hpp"
#include "certify/oracle/oracle.hpp"
#include "hunt/traced_cases.hpp"
#include "method/method.hpp"
#include "properties/envelope.hpp"
#include "properties/registry.hpp"
#include "query/judge.hpp"
#include "rapidcheck.hpp"
#include "scoreboard/planted.hpp"

namespace ccdfuzz {

namespace {

constexpr std::array kSoundMethods = {"tdibm-e", "tdibm-rational", "tdibm-c"};
constexpr SearchOptions kDriverSearch = {0x1p-6, 300, 1 << 24};

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

/// What the sources without the fault prove of a query, held against what those with it say.
std::string contradiction(const Query& query) {
  const int fault = planted::active_fault;
  planted::active_fault = 0;
  OracleOptions little;
  little.max_pops = 300;
  little.max_tree_nodes = 2000;
  Case known;
  known.query = query;
  known.truth = decide(query, little).truth;
  planted::active_fault = fault;
  if (const auto checked = check_truth(known); !checked) return checked.error().message();
  for (const char* method : kSoundMethods) {
    const Answer answer = (*make_method(method))->answer(query, kDriverSearch);
    const Outcome outcome = judge(query, known.truth, answer);
    if (is_false_negative(outcome) || outcome == Outcome::kError) {
      return fmt::format("{} is {}", method, name_of(outcome));
    }
  }
  return "";
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

/// Every property that holds, the one next that has taken the least time.
Step property_driver(std::uint64_t seed) {
  struct Turn {
    Property property;
    double seconds = 0;
    std::uint64_t index = 0;
  };
  auto turns = std::make_shared<std::vector<Turn>>();
  for (const Property& p : properties()) {
    if (p.expected == Expectation::kHolds) turns->push_back({p});
  }
  return [turns, seed](std::uint64_t) {
    Turn& turn = *std::min_element(turns->begin(), turns->end(), [](const Turn& x, const Turn& y) {
      return x.seconds < y.seconds;
    });
    const double start = cpu_seconds_used();
    RandomChoices choices{Random::keyed({seed, turn.index++})};
    const Check check = run(turn.property, choices);
    turn.seconds += cpu_seconds_used() - start;
    return check.status == Check::Status::kFails
               ? fmt::format("{}: {}", turn.property.name, check.text)
               : std::string();
  };
}

/// Witnesses through the inclusion tests, and now and then the whole query. tdibm-e claims nothing
/// where products underflow, so it sees only the first case of a block, which is not scaled.
Step hunt_driver(std::uint64_t seed) {
  auto block = std::make_shared<TracedBlock>();
  return [block, seed](std::uint64_t index) -> std::string {
    const std::uint64_t place = index % kTracedBlock;
    if (place == 0) *block = traced_block(seed, index / kTracedBlock);
    const Case& known = block->cases[place];
    if (const auto checked = check_truth(known); !checked) return checked.error().message();
    for (const char* method : kSoundMethods) {
      if (place != 0 && std::string_view(method) == "tdibm-e") continue;
      const auto tracer = *make_tracer(method);
      if (tracer->trace(known.query, *known.truth.witness, {.precision = 0x1p-8}).lost) {
        return fmt::format("{} loses a contact", method);
      }
      if (place % 4 != 0) continue;
      const Answer answer = (*make_method(method))->answer(known.query, kDriverSearch);
      const Outcome outcome = judge(known.query, known.truth, answer);
      if (is_false_negative(outcome) || outcome == Outcome::kError) {
        return fmt::format("{} is {}", method, name_of(outcome));
      }
    }
    return "";
  };
}

Step step_of(Driver driver, std::uint64_t seed) {
  switch (driver) {
    case Driver::kRandom:
      return random_driver(seed);
    case Driver::kRapidCheck:
      return rapidcheck_driver(seed);
    case Driver::kProperties:
      return property_driver(seed);
    case Driver::kHunt:
      return hunt_driver(seed);
  }
  return {};
}

}  // namespace

std::string_view name_of(Driver driver) {
  constexpr std::array<std::string_view, kDrivers.size()> kNames = {"random", "rapidcheck",
                                                                    "properties", "hunt"};
  return kNames[static_cast<std::size_t>(driver)];
}

double cpu_seconds_used() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

DriverRun drive(Driver driver, std::uint64_t seed, double cpu_seconds) {
  const Step step = step_of(driver, seed);
  DriverRun run;
  const double start = cpu_seconds_used();
  while (run.found.empty() && cpu_seconds_used() - start < cpu_seconds) {
    try {
      run.found = step(run.executions);
    } catch (const std::exception& error) {
      run.found = std::string("an exception: ") + error.what();
    }
    ++run.executions;
  }
  return run;
}

}  // namespace ccdfuzz
