#include "allocations.hpp"

#include <gtest/gtest.h>

#include "traced.hpp"

namespace ccdfuzz {
namespace {

TEST(Trace, AllocatesNothingOnceWarm) {
  std::vector<Case> cases;
  for (std::uint64_t index = 0; index < 4; ++index) {
    cases.push_back(generated_case(ContactClass::kFF, Family::kRegular, index));
    cases.push_back(generated_case(ContactClass::kVE, Family::kInteriorTime, index));
  }
  for (const std::string& spec : every_method_but()) {
    const auto tracer = tracer_of(spec);
    const auto trace_all = [&] {
      for (const Case& known : cases) {
        tracer->trace(known.query, *known.truth.witness, {.all = true});
      }
    };
    trace_all();
    const long before = allocations();
    trace_all();
    EXPECT_EQ(allocations() - before, 0) << spec;
  }
  EXPECT_GT(allocations(), 0) << "the counter counts";
}

}  // namespace
}  // namespace ccdfuzz
