#include <gtest/gtest.h>

#include "falling_vertex.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

/// Two points that meet at t = 1/2, with the witness that proves it.
std::string head_on(const std::string& t_max) {
  return R"({"format":"ccdfuzz-case","version":2,"patches":[)"
         R"({"shape":"point","positions":[[0,0,0]],"velocities":[[1,0,0]]},)"
         R"({"shape":"point","positions":[[1,0,0]],"velocities":[[-1,0,0]]}],"t_max":)" +
         t_max + R"(,"truth":{"collides":true,"witness":{"t":"1/2","uv":[["0","0"],["0","0"]]}}})";
}

TEST(Query, ACaseIsAskedAtThePrecisionThatItWasFoundAt) {
  const ScratchFolder folder;
  const std::string path = folder / "single.json";
  const auto pops = [&](const std::string& asked, const std::vector<std::string>& flags) {
    std::string text = head_on("1");
    text.insert(text.rfind('}'), asked);
    write_text(path, text);
    const Finished finished =
        succeeded(ccdfuzz(with({"query", path, "--methods", "tdibm", "--json"}, flags)));
    const auto rows = json_lines(finished.out);
    return rows.empty() ? 0 : rows[0].at("pops").get<int>();
  };
  const std::string coarse = R"(,"asked":{"precision":0.25})";
  EXPECT_LT(pops(coarse, {}), pops("", {}));
  EXPECT_EQ(pops(coarse, {"--precision", "1e-4"}), pops("", {}));
  EXPECT_EQ(pops(R"(,"asked":{"max_pops":3})", {}), 3);
}

TEST(Query, PrintsTheRowsBeforeTheFirstBadInput) {
  const ScratchFolder folder;
  const std::string good = folder / "good.json", bad = folder / "bad.json";
  write_text(good, head_on("1"));
  write_text(bad, head_on("-1"));
  const Finished finished = ccdfuzz({"query", good, bad, good, "--methods", "tdibm", "--json"});
  EXPECT_EQ(finished.code, 2);
  EXPECT_EQ(json_lines(finished.out).size(), 1U) << finished.out;
  EXPECT_THAT(finished.err, testing::HasSubstr(bad));
  EXPECT_THAT(finished.err, testing::HasSubstr("t_max"));
}

TEST(Threads, ChangeNothingThatIsPrintedOrWritten) {
  const ScratchFolder folder;
  std::string queries;
  for (int i = 0; i < 100; ++i) queries += falling_vertex("-1,2", 1) + falling_vertex("1,3", 0);
  write_text(folder / "vertex-face.csv", queries);
  const std::string set = generated(folder, "VE", "RP", 12), csv = folder / "vertex-face.csv",
                    out = folder / "out.jsonl";
  const auto made = [&](std::vector<std::string> command, const char* threads) {
    write_text(out, "");
    command.insert(command.end(), {"--threads", threads, "--json"});
    const std::string printed = succeeded(ccdfuzz(command)).out;
    EXPECT_NE(printed, "");
    return untimed(printed + read_text(out));
  };
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"query", set}, {"evaluate", csv}, {"import", csv, "--round", "-o", out}}) {
    const auto one = made(command, "1");
    EXPECT_EQ(one, made(command, "2"));
    EXPECT_EQ(one, made(command, "5"));
  }
}

}  // namespace
}  // namespace ccdfuzz
