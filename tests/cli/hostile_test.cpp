// Small files that ask for much: every command ends in seconds and in little memory, with an error
// or a refuted case that names the field and the limit.
#include <gmock/gmock.h>

#include <set>

#include "certify/checker/miss_tree.hpp"
#include "files/case_files.hpp"
#include "files/case_json.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

/// Runs the program with 1 GB of memory and 30 s of processor time, after which it is killed.
Finished limited(const std::string& arguments) {
  return shell("ulimit -v 1048576; ulimit -t 30; \"$ccdfuzz\" " + arguments);
}

MovingPatch<double> tensor8(double height, double up) {
  MovingPatch<double> patch;
  patch.shape = Shape::tensor(8, 8);
  for (int i = 0; i < patch.shape.control_count(); ++i) {
    patch.positions.emplace_back(i / 9 / 8.0, i % 9 / 8.0, height + i * i % 7 / 16.0);
    patch.velocities.emplace_back(0, 0, up);
  }
  return patch;
}

Query near_tensors() {
  return {{tensor8(0, 1), tensor8(1, -1)}, 1};
}

class Hostile : public testing::Test {
 protected:
  std::string file(const Case& value) const {
    const std::string path = folder_ / "case.json";
    write_text(path, to_json(value));
    return path;
  }
  std::string with_tree(const Query& query, const std::string& tree) const {
    Case value;
    value.query = query;
    value.truth.clear_until = Rational(1, 4);
    value.truth.clearance = MissTree{Rational(1, 4), {tree}};
    return file(value);
  }
  ScratchFolder folder_;
};

TEST_F(Hostile, AFileOfManyCasesThatNobodyDecidesIsLeftUndecidedAfterAWhile) {
  constexpr size_t kCases = 40;
  Case value;
  value.query = near_tensors();
  std::string cases;
  for (size_t i = 0; i < kCases; ++i) {
    value.query.t_max = 1 + static_cast<double>(i) / kCases;
    cases += to_json(value) + "\n";
  }
  const std::string path = folder_ / "cases.jsonl";
  write_text(path, cases);
  const std::string line = "query --methods tdibm --json " + path;
  std::set<std::string> outputs;
  for (const char* threads : {"1", "2"}) {
    const Finished asked = shell(fmt::format("\"$ccdfuzz\" {} --threads {}", line, threads));
    EXPECT_EQ(asked.code, 2) << asked.out;
    const size_t rows = json_lines(asked.out).size();
    EXPECT_GE(rows, 28U);
    EXPECT_LT(rows, kCases);
    EXPECT_THAT(asked.err, HasSubstr(fmt::format("{}:{}: this case and all after it are left "
                                                 "undecided: the default budget of a run",
                                                 path, rows + 1)));
    outputs.insert(asked.err.substr(asked.err.rfind("ccdfuzz: query: ")));  // after the progress
  }
  EXPECT_EQ(outputs.size(), 1U) << "depends on the number of threads";
  const Finished all = succeeded(shell("\"$ccdfuzz\" " + line + " --max-pops 10"));
  EXPECT_EQ(json_lines(all.out).size(), kCases);
}

TEST_F(Hostile, ManyCasesInAFewCompressedBytesEndAtALimitThatCountsBytes) {
  Truth truth;
  truth.collides = false;
  truth.proof = "rational-tdibm";
  const std::string path = folder_ / "cases.jsonl.zst";
  CaseWriter writer = CaseWriter::open(path).value();
  Case value;
  value.query = near_tensors();
  value.truth = truth;
  for (int i = 0; i < 5000; ++i) ASSERT_TRUE(writer.write(value));
  ASSERT_TRUE(writer.finish());
  EXPECT_LT(std::filesystem::file_size(path), 10'000U);
  refused(limited("verify " + path), "checking the cases up to this one takes more than ");
  refused(shell("ulimit -v 1048576; ulimit -t 120; \"$ccdfuzz\" replay --json --methods tdibm "
                "--expect correct " +
                path),
          "this case and all after it are left undecided");
}

/// All leaves of a tree hold the same bits: "0 1".
TEST_F(Hostile, AWideTreeIsRefused) {
  TreeBits bits;
  const auto grow = [&](const auto& self, int left) -> void {
    if (left == 0) return bits.leaf({0, 0, 1});
    bits.split(left % 2);
    for (int c = 0; c < 4; ++c) self(self, left - 1);
  };
  grow(grow, 8);
  Query query = near_tensors();
  for (Vec3<double>& p : query.patches[1].positions) p[2] += 100;  // every leaf holds
  const Finished verified = failed(limited("verify " + with_tree(query, bits.bytes())));
  EXPECT_THAT(verified.out, HasSubstr("truth.certificate.clear.tree: exceeds the work budget"));
}

TEST_F(Hostile, ABoxOfExtremeNumbersIsChecked) {
  Case value;
  value.query = near_tensors();
  for (MovingPatch<double>& patch : value.query.patches) {
    for (Vec3<double>& p : patch.positions) p[0] += 0x1p-1074, p[1] = 0x1p1000;
  }
  ContactBox box;
  box.centre = {0x1p-1040 + 0x1p-1074, 0.5 + 0x1p-52, 0x1p-1039 + 0x1p-1074, 0x1p-1000, 0.5};
  box.varied = {0, 2, 4};
  box.radius = {0x1p-1050, 0x1p-1050, 0x1p-1050};
  box.inverse = {{{0x1p1000, 0x1p-1074, 0}, {0, 0x1p1000, 0}, {0, 0x1p-1074, 1}}};
  value.truth.contact_box = box;
  failed(limited("verify " + file(value)));
}

}  // namespace
}  // namespace ccdfuzz
