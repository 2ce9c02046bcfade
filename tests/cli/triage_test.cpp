// triage and merge: what fuzzers found becomes entries of a corpus.
#include <gmock/gmock.h>

#include <filesystem>

#include "files/case_files.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

TEST(Triage, ReadsTheInputsOfFuzzTargetsInAFolder) {
  const ScratchFolder folder;
  CaseStream drawn({generated(folder, "VV", "RP", 6)});
  std::filesystem::create_directories(folder / "crashes/deep");
  std::size_t written = 0;
  while (const auto entry = drawn.next().value()) {
    const auto witnessed = contact_of(entry->value);
    const auto bytes = witnessed ? to_bytes(*witnessed) : std::nullopt;
    if (!bytes) continue;
    write_text(
        fmt::format("{}/{}", folder / (written % 2 == 0 ? "crashes" : "crashes/deep"), written),
        std::string(bytes->begin(), bytes->end()));
    ++written;
  }
  ASSERT_GT(written, 1U);
  const Finished run = succeeded(ccdfuzz(
      {"triage", folder / "crashes", "-o", folder / "finds", "--methods", "tdibm", "--json"}));
  const auto rows = json_lines(run.out);
  EXPECT_EQ(rows.back().at("inputs"), written);
  EXPECT_FALSE(entries_in(folder / "finds").empty());
  succeeded(ccdfuzz({"replay", folder / "finds"}));
}

TEST(Triage, SaysHowToAskOwnCodeWhereNoMethodFails) {
  const ScratchFolder folder;
  const std::string drawn = generated(folder, "VV", "RP", 1);
  const auto said_of = [&](const std::string& methods) {
    return succeeded(ccdfuzz({"triage", drawn, "-o", folder / "finds", "--methods", methods})).out;
  };
  const std::string hint = "ask it as a plug-in: --methods plugin:PATH";
  EXPECT_THAT(said_of("tdibm-c"), HasSubstr("1 inputs on which nothing fails"));
  EXPECT_THAT(said_of("tdibm-c"), HasSubstr(hint));
  EXPECT_THAT(said_of("tdibm-c,plugin:" CCDFUZZ_TEST_LINEAR_PLUGIN), Not(HasSubstr(hint)));
}

TEST(Triage, AsksABrokenContactAsItStandsAndMadeWhole) {
  const ScratchFolder folder;
  const auto drawn = read_case(generated(folder, "VV", "RP", 1));
  ASSERT_TRUE(drawn);
  auto witnessed = contact_of(drawn->value);
  ASSERT_TRUE(witnessed);
  for (Vec3<double>& p : witnessed->query.patches[0].positions) p[0] += 1;
  const auto bytes = to_bytes(*witnessed);
  ASSERT_TRUE(bytes);
  const auto repaired = contact_of_bytes(*bytes);
  ASSERT_TRUE(repaired);
  ASSERT_NE(repaired->query, *query_of(*bytes));
  write_text(folder / "input", std::string(bytes->begin(), bytes->end()));
  const Finished run = succeeded(ccdfuzz(
      {"triage", folder / "input", "-o", folder / "finds", "--methods", "tdibm", "--json"}));
  EXPECT_EQ(json_lines(run.out).back().at("inputs"), 2);
}

}  // namespace
}  // namespace ccdfuzz
