#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string feature_case(const std::string& patches, const std::string& witness,
                         const std::string& more = "") {
  return R"({"format":"ccdfuzz-case","version":2,"patches":[)" + patches + R"(],"t_max":1)" + more +
         R"(,"truth":{"collides":true,"witness":)" + witness + "}}";
}

/// Two balls that come as near as their radii at t = 1.
const std::string kBalls = feature_case(
    R"({"shape":"hull","positions":[[0,0,0]],"velocities":[[0,0,0]],"radius":0.5},)"
    R"({"shape":"hull","positions":[[0,1.75,0]],"velocities":[[0,-1,0]],"radius":0.25})",
    R"({"t":"1","weights":[["1"],["1"]]})");
const std::string kFallingPoint =
    R"({"shape":"point","positions":[[6,8,2]],"velocities":[[-6,-8,0]]})";
const std::string kAtHalf = R"({"t":"1/2","uv":[["1/2","1/2"],["0","0"]]})";
const std::string kArc = R"("positions":[[5,0,0],[5,0,4],[5,5,0],[5,5,4],[0,5,0],[0,5,4]],)";
/// A point that meets a quarter of a cylinder at t = 1/2.
const std::string kWeights = feature_case(
    R"({"shape":"tensor","degree":[2,1],)" + kArc +
        R"("weights":[1,1,1,1,2,2],"ends":[[5,0,0],[5,0,4],[5,5,0],[5,5,4],[0,5,0],[0,5,4]]},)" +
        kFallingPoint,
    kAtHalf);
/// The point stops a quarter away from a triangle.
const std::string kSeparation =
    feature_case(R"({"shape":"triangle","degree":1,"positions":[[0,0,0],[0,4,0],[4,0,0]],)"
                 R"("velocities":[[0,0,0],[0,0,0],[0,0,0]]},)"
                 R"({"shape":"point","positions":[[1,1,1.25]],"velocities":[[0,0,-1]]})",
                 R"({"t":"1","uv":[["1/4","1/4"],["0","0"]]})", R"(,"separation":0.25)");

/// The files of all three.
std::vector<std::string> feature_files(const ScratchFolder& folder) {
  std::vector<std::string> files = {folder / "a.json", folder / "b.json", folder / "c.json"};
  write_text(files[0], kBalls);
  write_text(files[1], kWeights);
  write_text(files[2], kSeparation);
  return files;
}

std::string out_of(const std::vector<std::string>& command, const std::vector<std::string>& files) {
  const Finished finished = succeeded(ccdfuzz(with(command, files)));
  std::istringstream lines(finished.out);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }), 80) << line;
  }
  EXPECT_THAT(finished.out, Not(HasSubstr("nan")));
  return finished.out;
}

TEST(QueryOfBodies, RunsTheOracleWhereNoMethodIsNamed) {
  const ScratchFolder folder;
  const std::vector<std::string> balls = {feature_files(folder)[0]};
  const std::string out = out_of({"query"}, balls);
  EXPECT_THAT(out, testing::ContainsRegex("oracle \\* +hit at 1 +correct"));
  EXPECT_THAT(out, Not(HasSubstr("refused")));
  EXPECT_THAT(out, HasSubstr("t_max 1: contact by t = 1\n")) << "of no class that is known";
  EXPECT_THAT(out, HasSubstr("1 case, 1 answer: 1 correct\n"));
  EXPECT_EQ(json_lines(ccdfuzz({"query", "--json", balls[0]}).out).size(), 1U);
  EXPECT_THAT(out_of({"query", "--methods", "tdibm"}, balls), HasSubstr("1 not asked"));
}

TEST(QueryOfFeatures, NamesAReasonToRefuseOnceForEachCase) {
  const ScratchFolder folder;
  const std::string out = out_of({"query"}, feature_files(folder));
  EXPECT_THAT(out, HasSubstr("b.json, tdibm-e, tdibm-e-literal: takes patches"));
  EXPECT_THAT(out, testing::ContainsRegex("tdibm-e \\* +refused +not asked +- +-\n"));
}

TEST(EvaluateOfFeatures, HasNoRowWithoutAnAnswer) {
  const ScratchFolder folder;
  const std::vector<std::string> files = feature_files(folder);
  const std::string out = out_of({"evaluate"}, files);
  EXPECT_THAT(out, Not(testing::ContainsRegex("\ntdibm-e \\*")));
  EXPECT_THAT(out, HasSubstr("Refused every query: tdibm-e, tdibm-e-literal\n"));
  EXPECT_THAT(out_of({"evaluate"}, {files[0]}), Not(HasSubstr("missed  ")));
}

TEST(TraceOfFeatures, LeavesOutMethodsThatRefuseWhereNoneIsNamed) {
  const ScratchFolder folder;
  const std::vector<std::string> files = feature_files(folder);
  EXPECT_THAT(out_of({"trace"}, {files[1], files[2]}), HasSubstr("; 7 not asked: "));
  refused(ccdfuzz({"trace", files[1], "--methods", "tdibm-e"}),
          "tdibm-e: takes patches without weights");
  refused(ccdfuzz({"trace", files[0]}), "patches are accepted");
}

TEST(HuntOfBodies, HasNoColumnOfLostMutants) {
  const ScratchFolder folder;
  for (const char* form : {"--binary32", "--by-class"}) {
    const std::string out =
        out_of({"hunt", "--bodies", "--cases", "1", form}, {"--corpus", folder / form});
    EXPECT_THAT(out, HasSubstr("mutants")) << form;
    EXPECT_THAT(out, Not(HasSubstr("lost"))) << form;
  }
}

}  // namespace
}  // namespace ccdfuzz
