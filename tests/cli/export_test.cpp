// What export makes of cases, built and run.
#include <filesystem>

#include "process.hpp"

namespace ccdfuzz {
namespace {

/// A vertex that moves down at this speed over a face, from 1 above its inside.
std::string vertex_onto_face(double speed, const std::string& truth) {
  constexpr const char* kCase =
      R"({{"format":"ccdfuzz-case","version":2,"patches":[{{"shape":"triangle","degree":1,)"
      R"("positions":[[0,0,0],[0,1,0],[1,0,0]],"velocities":[[0,0,0],[0,0,0],[0,0,0]]}},)"
      R"({{"shape":"point","positions":[[0.25,0.5,1]],"velocities":[[0,0,{}]]}}],"t_max":1,)"
      R"("truth":{{{}}}}})"
      "\n";
  return fmt::format(kCase, -speed, truth);
}

/// One that reaches the face, one that stays above it, and one that reaches it at t_max.
const std::string kReachesTheFace =
    vertex_onto_face(2, R"("collides":true,"witness":{"t":"1/2","uv":[["1/4","1/2"],["0","0"]]})");
const std::string kStaysAbove =
    vertex_onto_face(0.5, R"("collides":false,"proof":"L",)"
                          R"("certificate":{"clear":{"kind":"L","until":"1","closed":true}})");
const std::string kReachesItLater = vertex_onto_face(
    0.875, R"("witness":{"t":"8/7","uv":[["1/4","1/2"],["0","0"]]},"clear_until":"8/7",)"
           R"("certificate":{"clear":{"kind":"L","until":"8/7","closed":false}})");
const std::string kContactAtTheEnd =
    vertex_onto_face(1, R"("collides":true,"witness":{"t":"1","uv":[["1/4","1/2"],["0","0"]]})");

/// Two balls that meet, of which K is proven.
const std::string kBallOntoBall =
    R"({"format":"ccdfuzz-case","version":2,"patches":[)"
    R"({"shape":"hull","positions":[[0,0,0]],"velocities":[[0,0,0]],"radius":1},)"
    R"({"shape":"hull","positions":[[0,0,3]],"velocities":[[0,0,-1]],"radius":1}],"t_max":2,)"
    R"("truth":{"collides":true,"witness":{"t":"1","weights":[["1"],["1"]]},"clear_until":"1",)"
    R"("certificate":{"clear":{"kind":"K","until":"1","normal":["0","0","1"],"closed":false}}}})"
    "\n";

/// A contact of a patch with equal weights and ends.
const std::string kWeightsAndEnds =
    R"({"format":"ccdfuzz-case","version":2,"patches":[{"shape":"triangle","degree":1,)"
    R"("positions":[[0,0,0],[1,0,0],[0,1,0]],"ends":[[0,0,0],[1,0,0],[0,1,0]],)"
    R"("weights":[1,1,1]},)"
    R"({"shape":"point","positions":[[0.25,0.25,1]],"ends":[[0.25,0.25,-1]]}],"t_max":1,)"
    R"("truth":{"collides":true,"witness":{"t":"1/2","uv":[["1/4","1/4"],["0","0"]]}}})"
    "\n";

/// A contact of a face with two loops, which claiming_plugin.cpp knows.
const std::string kTrimmed =
    R"({"format":"ccdfuzz-case","version":2,"patches":[{"shape":"triangle","degree":1,)"
    R"("positions":[[0,0,0],[1,0,0],[0,1,0]],"velocities":[[0,0,0],[0,0,0],[0,0,0]],)"
    R"("trim":[[[0,0],[1,0],[0,1]],[[0.125,0.125],[0.25,0.125],[0.25,0.25],[0.125,0.25]]]},)"
    R"({"shape":"point","positions":[[0.5,0.375,1]],"velocities":[[0,0,-2]]}],"t_max":1,)"
    R"("truth":{"collides":true,"witness":{"t":"1/2","uv":[["3/8","1/2"],["0","0"]]}}})"
    "\n";

/// The exported tests of some cases.
class ExportedTests {
 public:
  explicit ExportedTests(const std::string& cases) {
    write_text(cases_, cases);
    succeeded(ccdfuzz({"export", cases_, "--as", "gtest", "-o", folder_ / "found_test.cpp"}));
    compile("-Wall -Wextra -Werror -c found_test.cpp -o test.o");
    claiming_ = with_plugin(CCDFUZZ_TEST_CLAIMING_PLUGIN);
  }

  /// The program that they make with this library.
  std::string with_plugin(const std::string& plugin) const {
    compile(
        fmt::format("test.o {0} -Wl,-rpath,$(dirname {0}) -o test-$(basename {0}) "
                    "-lgtest_main -lgtest -pthread",
                    plugin));
    return folder_ / "test-" + std::filesystem::path(plugin).filename().string();
  }

  /// Whether claiming_plugin.cpp with these options passes. Expects that replay calls it wrong
  /// exactly if it does not.
  bool pass(const std::string& options) const {
    const bool passed = shell("CCDFUZZ_PLUGIN_OPTIONS=" + options + " " + claiming_).code == 0;
    const std::string plugin = "plugin:" CCDFUZZ_TEST_CLAIMING_PLUGIN ":" + options;
    const Finished replayed =
        ccdfuzz({"replay", cases_, "--methods", plugin, "--expect", "correct"});
    const bool is_wrong = replayed.out.find("regression") != std::string::npos;
    EXPECT_EQ(passed, !is_wrong) << options << ": " << replayed.out;
    return passed;
  }

 private:
  void compile(const std::string& arguments) const {
    succeeded(shell(fmt::format("cd {} && {} -std=c++17 -I{}/src/method/plugin {}", folder_.path(),
                                CCDFUZZ_CXX, CCDFUZZ_SOURCE_DIR, arguments)));
  }

  ScratchFolder folder_;
  const std::string cases_ = folder_ / "cases.jsonl";
  std::string claiming_;
};

TEST(Export, AsGoogleTestFailsWithAPluginThatFailsAndPassesWithOneThatDoesNot) {
  const ExportedTests tests(kReachesTheFace + kStaysAbove);
  const Finished right = succeeded(shell(tests.with_plugin(CCDFUZZ_TEST_LINEAR_PLUGIN)));
  EXPECT_THAT(right.out, testing::HasSubstr("[  PASSED  ] 2 tests"));
  EXPECT_FALSE(tests.pass("verdict=2")) << "misses the contact";
  EXPECT_FALSE(tests.pass("verdict=1")) << "hits what does not touch";
}

TEST(Export, AsGoogleTestSaysWhatAPluginAnswersAndThatItRefusesItsOptions) {
  const ExportedTests tests(kReachesTheFace);
  const std::string claiming = tests.with_plugin(CCDFUZZ_TEST_CLAIMING_PLUGIN);
  const std::string linear = tests.with_plugin(CCDFUZZ_TEST_LINEAR_PLUGIN);
  for (const auto& [options, program, why] :
       {std::array{std::string("refuse=1"), claiming, std::string("as the options say")},
        {"verdict=2", claiming, "answered miss; they touch by t = 0.5 (0x1p-1)"},
        {"nonsense", linear, "refuses CCDFUZZ_PLUGIN_OPTIONS=\"nonsense\""}}) {
    const Finished refused = shell("CCDFUZZ_PLUGIN_OPTIONS=" + options + " " + program);
    EXPECT_EQ(refused.code, 1);
    EXPECT_THAT(refused.out, testing::HasSubstr(why));
  }
}

TEST(Export, AsGoogleTestAllowsTheToleranceInTimeThatAPluginClaims) {
  const ExportedTests tests(kReachesTheFace);
  EXPECT_TRUE(tests.pass("verdict=1:toi=0x1.00002p-1:kind=1:tolerance=1e-6"));
  EXPECT_FALSE(tests.pass("verdict=1:toi=0x1.00004p-1:kind=1:tolerance=1e-6"));
}

TEST(Export, AsGoogleTestRefusesWhatAPluginIsNeverAskedInItsPlace) {
  const ExportedTests tests(kReachesTheFace);
  EXPECT_TRUE(tests.pass("verdict=4:within=1"));
  EXPECT_TRUE(tests.pass("verdict=4:curves=1"));
  EXPECT_FALSE(tests.pass("verdict=4:within=2"));
}

/// A point that is 1 above a face at 0 and on it at 1/2 is 1/4 above it at 3/8.
TEST(Export, AsGoogleTestAsksForTheSeparationThatAConservativePluginClaims) {
  const ExportedTests tests(kReachesTheFace);
  EXPECT_TRUE(tests.pass("verdict=1:toi=0.375:separation=0.25:claims=7"));
  EXPECT_FALSE(tests.pass("verdict=1:toi=0.376:separation=0.25:claims=7"));
  EXPECT_TRUE(tests.pass("verdict=1:toi=0.376:separation=0.25:claims=6"));
  EXPECT_TRUE(tests.pass("verdict=1:toi=0.376:separation=2:claims=3"));
  EXPECT_FALSE(tests.pass("verdict=1:toi=0.001:separation=2:claims=7"));
  EXPECT_FALSE(ExportedTests(kReachesItLater).pass("verdict=2:separation=0.25:claims=7"));
}

// Bits of claims are those of ccdfuzz_description: 1 conservative, 2 closed at t_max, 4 contact at
// 0, 8 ends, 32 weights, 64 bodies, 128 trims.
TEST(Export, AsGoogleTestAsksForNoContactAtAnEndThatIsNotClaimedAndLetsAPluginRefuse) {
  const ExportedTests tests(kContactAtTheEnd);
  EXPECT_TRUE(tests.pass("verdict=2:claims=4"));
  EXPECT_FALSE(tests.pass("verdict=2:claims=2"));
  EXPECT_TRUE(tests.pass("verdict=5:claims=2"));
}

TEST(Export, AsGoogleTestAllowsTheDepthOfBodiesThatAPluginTolerates) {
  const ExportedTests tests(kBallOntoBall);
  const std::string an_eighth = ":kind=2:tolerance=0.125:claims=";
  EXPECT_TRUE(tests.pass("verdict=1:toi=1.12" + an_eighth + "66"));
  EXPECT_FALSE(tests.pass("verdict=1:toi=1.25" + an_eighth + "66"));
  EXPECT_FALSE(tests.pass("verdict=2" + an_eighth + "66"));
  EXPECT_FALSE(tests.pass("verdict=1:toi=1.12" + an_eighth + "67"));
}

/// To weights and to ends its answer is a hit at 0.
TEST(Export, AsGoogleTestAsksForWeightsAndEndsAsAPluginTakesThem) {
  const ExportedTests tests(kWeightsAndEnds);
  EXPECT_FALSE(tests.pass("verdict=2:claims=2"));
  EXPECT_TRUE(tests.pass("verdict=2:claims=34"));
  EXPECT_TRUE(tests.pass("verdict=2:claims=10"));
}

TEST(Export, AsGoogleTestAsksForTrimsOnlyWhatTakesThem) {
  const ExportedTests tests(kTrimmed);
  EXPECT_TRUE(tests.pass("verdict=2:claims=130"));
  EXPECT_FALSE(tests.pass("verdict=1:toi=0.75:claims=130"));
  EXPECT_TRUE(tests.pass("verdict=2:claims=2")) << "it is not asked";
}

TEST(Export, AsCatch2Compiles) {
  const ScratchFolder folder;
  write_text(folder / "cases.jsonl", kReachesTheFace + kStaysAbove + kBallOntoBall + kTrimmed);
  // A stand-in for the macros of Catch2 that are used. It refuses "||" and chains as Catch2 does.
  std::filesystem::create_directories(folder / "catch2");
  write_text(folder / "catch2/catch_test_macros.hpp",
             "#define TEST_CASE(name) static void test_case(const char (*)[__LINE__])\n"
             "#define INFO(text) static_cast<void>(text)\n"
             "struct Compared {};\n"
             "struct Left { template <class T> Compared operator!=(const T&) const; };\n"
             "struct Begin { template <class T> Left operator<=(const T&) const; };\n"
             "#define CHECK(condition) static_cast<void>(Begin() <= condition)\n");
  succeeded(ccdfuzz(
      {"export", folder / "cases.jsonl", "--as", "catch2", "-o", folder / "found_test.cpp"}));
  succeeded(shell(
      fmt::format("cd {} && {} -std=c++17 -fsyntax-only -I. -I{}/src/method/plugin found_test.cpp",
                  folder.path(), CCDFUZZ_CXX, CCDFUZZ_SOURCE_DIR)));
}

}  // namespace
}  // namespace ccdfuzz
