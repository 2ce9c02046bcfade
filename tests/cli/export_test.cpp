// What export makes of cases, built and run.
#include <filesystem>

#include "process.hpp"

namespace ccdfuzz {
namespace {

/// A vertex that reaches a face in its inside, and one that stays above it.
constexpr const char* kTwoLinearCases =
    R"({"format":"ccdfuzz-case","version":1,"patches":[{"shape":"triangle","degree":1,"positions":[[0,0,0],[0,1,0],[1,0,0]],"velocities":[[0,0,0],[0,0,0],[0,0,0]]},{"shape":"point","positions":[[0.25,0.5,1]],"velocities":[[0,0,-2]]}],"t_max":1,"truth":{"collides":true,"witness":{"t":"1/2","uv":[["1/4","1/2"],["0","0"]]}}}
{"format":"ccdfuzz-case","version":1,"patches":[{"shape":"triangle","degree":1,"positions":[[0,0,0],[0,1,0],[1,0,0]],"velocities":[[0,0,0],[0,0,0],[0,0,0]]},{"shape":"point","positions":[[0.25,0.5,1]],"velocities":[[0,0,-0.5]]}],"t_max":1,"truth":{"collides":false,"proof":"L","certificate":{"clear":{"kind":"L","until":"1","closed":true}}}}
)";

/// Always wrong: says the opposite of what the example says.
constexpr const char* kContrary = R"(#include "ccdfuzz_plugin.hpp"
namespace ccd = ccdfuzz_plugin_cpp;
struct Contrary {
  explicit Contrary(const std::string&) {}
  static ccd::Description describe() { return {"contrary", ""}; }
  static ccd::Answer answer(const ccd::Query& query) {
    const bool comes = query.raw.patches[1]->velocities[0][2] == -2;
    return comes ? ccd::Answer::miss() : ccd::Answer::hit(0);
  }
};
CCDFUZZ_PLUGIN(Contrary)
)";

TEST(Export, AsGoogleTestFailsWithAPluginThatFailsAndPassesWithOneThatDoesNot) {
  const ScratchFolder folder;
  write_text(folder / "cases.jsonl", kTwoLinearCases);
  write_text(folder / "contrary.cpp", kContrary);
  const Finished written = succeeded(ccdfuzz(
      {"export", folder / "cases.jsonl", "--as", "gtest", "-o", folder / "found_test.cpp"}));
  EXPECT_EQ(written.out, "2 tests\n");
  succeeded(
      shell(fmt::format("cd {0} && cxx='{1} -std=c++17 -I{2}/src/method/plugin' && "
                        "$cxx -Wall -Wextra -Werror -c found_test.cpp -o test.o && "
                        "$cxx test.o contrary.cpp -o wrong -lgtest_main -lgtest -pthread && "
                        "$cxx test.o {3} -Wl,-rpath,{4} -o right -lgtest_main -lgtest -pthread",
                        folder.path(), CCDFUZZ_CXX, CCDFUZZ_SOURCE_DIR, CCDFUZZ_TEST_LINEAR_PLUGIN,
                        std::filesystem::path(CCDFUZZ_TEST_LINEAR_PLUGIN).parent_path().string())));
  const Finished right = succeeded(Process({}, "", folder / "right").wait());
  EXPECT_THAT(right.out, testing::HasSubstr("[  PASSED  ] 2 tests"));
  const Finished wrong = failed(Process({}, "", folder / "wrong").wait());
  EXPECT_THAT(wrong.out, testing::HasSubstr("2 FAILED TESTS"));
}

/// LATE of t_max late, and claims that it may be by a millionth.
constexpr const char* kLateByItsTolerance = R"(#include "ccdfuzz_plugin.hpp"
namespace ccd = ccdfuzz_plugin_cpp;
struct Late {
  explicit Late(const std::string&) {}
  static ccd::Description describe() {
    ccd::Description description{"late", ""};
    description.tolerance_kind = CCDFUZZ_TOLERANCE_TIME_RELATIVE;
    description.tolerance = 1e-6;
    return description;
  }
  static ccd::Answer answer(const ccd::Query& query) {
    const bool comes = query.raw.patches[1]->velocities[0][2] == -2;
    return comes ? ccd::Answer::hit(0.5 + LATE) : ccd::Answer::miss();
  }
};
CCDFUZZ_PLUGIN(Late)
)";

TEST(Export, AsGoogleTestAllowsTheToleranceInTimeThatAPluginClaims) {
  const ScratchFolder folder;
  write_text(folder / "cases.jsonl", kTwoLinearCases);
  write_text(folder / "late.cpp", kLateByItsTolerance);
  succeeded(ccdfuzz(
      {"export", folder / "cases.jsonl", "--as", "gtest", "-o", folder / "found_test.cpp"}));
  succeeded(shell(fmt::format(
      "cd {0} && cxx='{1} -std=c++17 -I{2}/src/method/plugin' && $cxx -c found_test.cpp -o t.o && "
      "$cxx t.o late.cpp -DLATE=0x1p-20 -o within -lgtest_main -lgtest -pthread && "
      "$cxx t.o late.cpp -DLATE=0x1p-19 -o beyond -lgtest_main -lgtest -pthread",
      folder.path(), CCDFUZZ_CXX, CCDFUZZ_SOURCE_DIR)));
  EXPECT_EQ(Process({}, "", folder / "within").wait().code, 0);
  EXPECT_EQ(Process({}, "", folder / "beyond").wait().code, 1);
}

/// A contact at t_max, and a ball that comes into a box, of which K is proven.
constexpr const char* kContactAtTheEnd =
    R"({"format":"ccdfuzz-case","version":2,"patches":[{"shape":"triangle","degree":1,)"
    R"("positions":[[0,0,0],[1,0,0],[0,1,0]],"velocities":[[0,0,0],[0,0,0],[0,0,0]]},)"
    R"({"shape":"point","positions":[[0.25,0.25,1]],"velocities":[[0,0,-1]]}],"t_max":1,)"
    R"("truth":{"collides":true,"witness":{"t":"1","uv":[["1/4","1/4"],["0","0"]]}}})"
    "\n";
constexpr const char* kBallOntoBall =
    R"({"format":"ccdfuzz-case","version":2,"patches":[)"
    R"({"shape":"hull","positions":[[0,0,0]],"velocities":[[0,0,0]],"radius":1},)"
    R"({"shape":"hull","positions":[[0,0,3]],"velocities":[[0,0,-1]],"radius":1}],"t_max":2,)"
    R"("truth":{"collides":true,"witness":{"t":"1","weights":[["1"],["1"]]},"clear_until":"1",)"
    R"("certificate":{"clear":{"kind":"K","until":"1","normal":["0","0","1"],"closed":false}}}})"
    "\n";

/// A contact of a patch with equal weights and one with ends.
constexpr const char* kWeightsAndEnds =
    R"({"format":"ccdfuzz-case","version":2,"patches":[{"shape":"triangle","degree":1,)"
    R"("positions":[[0,0,0],[1,0,0],[0,1,0]],"velocities":[[0,0,0],[0,0,0],[0,0,0]],)"
    R"("weights":[2,2,2]},)"
    R"({"shape":"point","positions":[[0.25,0.25,1]],"ends":[[0.25,0.25,-1]]}],"t_max":1,)"
    R"("truth":{"collides":true,"witness":{"t":"1/2","uv":[["1/4","1/4"],["0","0"]]}}})"
    "\n";

/// Answers ANSWER, and claims no more than CLAIMS and a tolerance in space of 1/8.
constexpr const char* kClaimsLittle = R"(#include "ccdfuzz_plugin.hpp"
namespace ccd = ccdfuzz_plugin_cpp;
struct Little {
  explicit Little(const std::string&) {}
  static ccd::Description describe() {
    ccd::Description description{"little", ""};
    description.claims = CLAIMS;
    description.tolerance_kind = CCDFUZZ_TOLERANCE_SPACE;
    description.tolerance = 0.125;
    return description;
  }
  static ccd::Answer answer([[maybe_unused]] const ccd::Query& query) {
    ANSWER;
  }
};
CCDFUZZ_PLUGIN(Little)
)";

/// Whether a plug-in that answers so passes the exported test of a case. Expects that replay calls
/// it wrong exactly if it does not.
bool passes(const std::string& text, const std::string& claims, const std::string& answer) {
  const ScratchFolder folder;
  write_text(folder / "case.jsonl", text);
  write_text(folder / "little.cpp", kClaimsLittle);
  succeeded(
      ccdfuzz({"export", folder / "case.jsonl", "--as", "gtest", "-o", folder / "found_test.cpp"}));
  succeeded(shell(
      fmt::format("cd {0} && cxx='{1} -std=c++17 -I{2}/src/method/plugin' && "
                  "$cxx '-DCLAIMS={3}' '-DANSWER={4}' -shared -fPIC little.cpp -o little.so && "
                  "$cxx found_test.cpp {0}/little.so -o test -lgtest_main -lgtest -pthread",
                  folder.path(), CCDFUZZ_CXX, CCDFUZZ_SOURCE_DIR, claims, answer)));
  const bool passed = shell(folder / "test").code == 0;
  const Finished replayed = ccdfuzz({"replay", folder / "case.jsonl", "--methods",
                                     "plugin:" + (folder / "little.so"), "--expect", "correct"});
  const bool is_wrong = replayed.out.find("regression") != std::string::npos;
  EXPECT_EQ(passed, !is_wrong) << claims << ", " << answer << ": " << replayed.out;
  return passed;
}

TEST(Export, AsGoogleTestAsksForNoContactAtAnEndThatIsNotClaimed) {
  EXPECT_TRUE(passes(kContactAtTheEnd, "CCDFUZZ_CONTACT_AT_ZERO", "return ccd::Answer::miss()"));
  EXPECT_FALSE(passes(kContactAtTheEnd, "CCDFUZZ_CLOSED_T_MAX", "return ccd::Answer::miss()"));
}

TEST(Export, AsGoogleTestAllowsTheDepthOfBodiesThatAPluginTolerates) {
  const std::string takes = "CCDFUZZ_CLOSED_T_MAX | CCDFUZZ_TAKES_BODIES";
  EXPECT_TRUE(passes(kBallOntoBall, takes, "return ccd::Answer::hit(0.56 * query.t_max())"));
  EXPECT_FALSE(passes(kBallOntoBall, takes, "return ccd::Answer::hit(0.625 * query.t_max())"));
  EXPECT_FALSE(passes(kBallOntoBall, takes, "return ccd::Answer::miss()"));
  EXPECT_FALSE(passes(kBallOntoBall, takes + " | CCDFUZZ_CONSERVATIVE",
                      "return ccd::Answer::hit(0.56 * query.t_max())"));
}

TEST(Export, AsGoogleTestAsksForWeightsAndEndsAsAPluginTakesThem) {
  const std::string answer =
      "return query.raw.patches[0]->weights || query.raw.patches[1]->ends"
      " ? ccd::Answer::miss() : ccd::Answer::hit(0)";
  const std::string closed = "CCDFUZZ_CLOSED_T_MAX";
  EXPECT_TRUE(passes(kWeightsAndEnds, closed, answer));
  EXPECT_FALSE(passes(kWeightsAndEnds, closed + " | CCDFUZZ_TAKES_WEIGHTS", answer));
  EXPECT_FALSE(passes(kWeightsAndEnds, closed + " | CCDFUZZ_TAKES_ENDS", answer));
}

TEST(Export, AsGoogleTestLetsAPluginRefuse) {
  EXPECT_TRUE(passes(kContactAtTheEnd, "CCDFUZZ_CLOSED_T_MAX", "throw ccd::Refusal(\"not mine\")"));
}

TEST(Export, AsCatch2Compiles) {
  const ScratchFolder folder;
  write_text(folder / "cases.jsonl", kTwoLinearCases);
  // A stand-in for the two macros of Catch2 that are used.
  std::filesystem::create_directories(folder / "catch2");
  write_text(folder / "catch2/catch_test_macros.hpp",
             "#define TEST_CASE(name) static void test_case(const char (*)[__LINE__])\n"
             "#define CHECK(condition) static_cast<void>(condition)\n");
  succeeded(ccdfuzz(
      {"export", folder / "cases.jsonl", "--as", "catch2", "-o", folder / "found_test.cpp"}));
  succeeded(shell(
      fmt::format("cd {} && {} -std=c++17 -fsyntax-only -I. -I{}/src/method/plugin found_test.cpp",
                  folder.path(), CCDFUZZ_CXX, CCDFUZZ_SOURCE_DIR)));
}

}  // namespace
}  // namespace ccdfuzz
