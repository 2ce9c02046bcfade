#include <gtest/gtest.h>

#include <filesystem>

#include "files/case_files.hpp"
#include "traced.hpp"

namespace ccdfuzz {
namespace {

// A method that answers "no contact" has lost the witness in all its pairs. One that is late has
// lost it in the earlier ones.
TEST(Corpus, HasTracesThatLoseTheWitnessWhereAMethodMissesAndSoundOnesThatKeepIt) {
  int entries = 0, losses = 0;
  for (const auto& file : std::filesystem::directory_iterator(CCDFUZZ_CORPUS "/cases")) {
    if (file.path().extension() != ".json") continue;
    SCOPED_TRACE(file.path().filename());
    const Case entry = value_or_throw(read_case(file.path())).value;
    if (!entry.truth.witness) continue;
    ++entries;
    const TraceOptions options{entry.asked.precision, true};
    for (const auto& [spec, expected] : entry.expect) {
      const Outcome outcome = expected.outcome;
      if (outcome != Outcome::kMissed && outcome != Outcome::kLate) continue;
      const Trace trace = tracer_of(spec)->trace(entry.query, *entry.truth.witness, options);
      EXPECT_TRUE(trace.lost) << spec;
      if (!trace.lost) continue;
      EXPECT_GE(trace.loss->by.axis, 0) << spec << ": an axis must claim it";
      EXPECT_GT(trace.false_claims, 0U) << spec;
      ++losses;
    }
    for (const std::string& spec : kSound) {
      EXPECT_FALSE(tracer_of(spec)->trace(entry.query, *entry.truth.witness, options).lost) << spec;
    }
  }
  EXPECT_GT(entries, 10);
  EXPECT_GT(losses, 20);
}

}  // namespace
}  // namespace ccdfuzz
