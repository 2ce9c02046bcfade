#include <gtest/gtest.h>

#include "files/case_files.hpp"
#include "files/case_json.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

/// The first generated case, changed, in a file of its own.
template <class Change>
std::string changed_case(const ScratchFolder& folder, const std::string& kind,
                         const Change& change) {
  auto cases = read_cases(generated(folder, "VV", kind, 1));
  Case value = cases->at(0).value;
  change(value);
  const std::string path = folder / "changed.json";
  write_text(path, to_json(value));
  return path;
}

TEST(Verify, ReadsOnPastARefutedTruthAndExits1) {
  const ScratchFolder folder;
  const std::string wrong = changed_case(folder, "RP", [](Case& c) {
    for (Vec3<double>& p : c.query.patches[0].positions) p[0] += 0x1p-40;
  });
  const std::string good = generated(folder, "VV", "RN", 2);
  const Finished finished = failed(ccdfuzz({"verify", wrong, good, "--json"}));
  const auto rows = json_lines(finished.out);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].at("case"), wrong);
  EXPECT_EQ(rows[0].at("truth"), "refuted");
  EXPECT_NE(rows[0].at("note").get<std::string>().find("witness"), std::string::npos);
  EXPECT_EQ(rows[1].at("truth"), "holds");
  EXPECT_EQ(rows[2].at("truth"), "holds");
  // Every other command refuses it.
  EXPECT_EQ(ccdfuzz({"query", wrong}).code, 2);
}

TEST(Verify, AnAbsenceThatDoesNotHoldIsUnproven) {
  const ScratchFolder folder;
  // Asked past the contact, the negative case collides; its witness was never in the file.
  const std::string wrong = changed_case(folder, "RN", [](Case& c) {
    c.query.t_max = 1.5;
    c.truth.clear_until.reset();
    c.truth.clearance.reset();
    c.truth.proof = "rational-tdibm";
  });
  const Finished finished = failed(ccdfuzz({"verify", wrong}));
  EXPECT_THAT(finished.out, testing::HasSubstr("unproven"));
  EXPECT_NE(finished.out.find("1 case: 0 hold, 0 refuted, 1 unproven"), std::string::npos);
}

}  // namespace
}  // namespace ccdfuzz
