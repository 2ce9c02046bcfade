#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

/// Two points that meet at t = 1/2; `truth` is what the case says of that.
std::string head_on(const std::string& t_max, const std::string& truth) {
  return R"({"format":"ccdfuzz-case","version":1,"patches":[)"
         R"({"shape":"point","positions":[[0,0,0]],"velocities":[[1,0,0]]},)"
         R"({"shape":"point","positions":[[1,0,0]],"velocities":[[-1,0,0]]}],"t_max":)" +
         t_max + truth + "}";
}

const std::string kWitness = R"("witness":{"t":"1/2","uv":[["0","0"],["0","0"]]})";

TEST(Trace, ACaseWithoutAWitnessInItsStepIsAnErrorThatNamesIt) {
  const ScratchFolder folder;
  const std::string none = folder / "none.json", late = folder / "late.json";
  write_text(none, head_on("1", ""));
  write_text(late, head_on("0.25", R"(,"truth":{)" + kWitness + "}"));
  refused(ccdfuzz({"trace", none}), none + ": truth.witness: is missing");
  const Finished past = refused(ccdfuzz({"trace", late}), "1/2 is past t_max 0.25");
  EXPECT_EQ(past.out, "");
}

TEST(Trace, AMethodThatCannotBeTracedIsBadInput) {
  const std::string naive = std::string("plugin:") + CCDFUZZ_TEST_NAIVE_PLUGIN;
  const std::string entry = CCDFUZZ_SOURCE_DIR "/corpus/cases/tdibm-e-underflow.json";
  const Finished done =
      refused(ccdfuzz({"trace", "--methods", "tdibm," + naive, entry}), "cannot be traced");
  EXPECT_EQ(done.out, "");
}

}  // namespace
}  // namespace ccdfuzz
