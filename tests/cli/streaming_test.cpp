// A data set whose cases would take much memory together: commands hold only some of them.
#include <gmock/gmock.h>

#include <fstream>

#include "falling_vertex.hpp"
#include "files/case_files.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

constexpr std::uint64_t kManyCases = 2'800;
constexpr size_t kNoteBytes = 100'000;
/// Half of what the notes alone take; the program without cases takes some 15 MB.
constexpr std::uint64_t kSmall = kManyCases * kNoteBytes / 2;

/// A point that moves down onto a triangle and reaches it at t = 1.
Case contact_with_a_long_note() {
  Case value;
  const Vec3<double> still(0, 0, 0);
  value.query.patches[0] = {Shape::point(), {{0.25, 0.25, 1}}, {{0, 0, -1}}};
  value.query.patches[1] = {
      Shape::triangle(1), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {still, still, still}};
  value.query.t_max = 1;
  const Rational quarter(1, 4);
  value.truth.collides = true;
  value.truth.witness = Witness{1, {Uv<Rational>{0, 0}, Uv<Rational>{quarter, quarter}}};
  value.origin.contact = "VF";
  value.origin.kind = "RP";
  value.origin.note = std::string(kNoteBytes, 'x');
  return value;
}

class Streaming : public testing::Test {
 protected:
  Streaming() {
    CaseWriter writer = CaseWriter::open(set_).value();
    Case value = contact_with_a_long_note();
    for (value.origin.index = 0; *value.origin.index < kManyCases; ++*value.origin.index) {
      EXPECT_TRUE(writer.write(value));
    }
    EXPECT_TRUE(writer.finish());
    EXPECT_LT(std::filesystem::file_size(set_), 1'000'000U);
  }

  Finished run(const std::string& command) const {
    return shell(fmt::format("cd {}; $ccdfuzz {}", folder_.path(), command));
  }

  const ScratchFolder folder_;
  const std::string set_ = folder_ / "set.jsonl.zst";
};

TEST_F(Streaming, CommandsThatLookAtOneCaseHoldFewOfThem) {
  for (const char* command :
       {"verify set.jsonl.zst", "query set.jsonl.zst --methods tdibm-c",
        "query set.jsonl.zst --methods tdibm-c,tdibm --json",
        "trace set.jsonl.zst --methods tdibm-c", "prove set.jsonl.zst -o proven.jsonl.zst",
        "replay set.jsonl.zst --methods tdibm-c --expect correct",
        "triage set.jsonl.zst --methods tdibm-c --seconds 5 -o finds",
        "evaluate set.jsonl.zst --methods tdibm-c -o answers", "export set.jsonl.zst -o out.csv",
        "export set.jsonl.zst --as catch2 -o out.cpp"}) {
    const Finished finished = run(command);
    EXPECT_EQ(finished.code, 0) << command << finished.err;
    EXPECT_LT(finished.peak_bytes, kSmall) << command;
  }
}

TEST_F(Streaming, MinimizeReadsTwoCases) {
  const Finished minimized = refused(run("minimize set.jsonl.zst --method tdibm"),
                                     "set.jsonl.zst: holds more than one case");
  EXPECT_LT(minimized.peak_bytes, kSmall);
}

TEST(StreamingCsv, TenTimesTheQueriesTakeNoMoreMemory) {
  constexpr int kFew = 1'250, kMany = 10 * kFew;
  const ScratchFolder folder;
  const auto peaks = [&](const std::string& name, int queries) {
    std::ofstream file(folder / (name + "-vertex-face.csv"));
    for (int i = 0; i < queries; ++i) file << falling_vertex(i % 2 == 0 ? "-1,2" : "1,2", 1);
    file.close();
    std::vector<std::uint64_t> bytes;
    for (const char* command :
         {"evaluate {0} --methods tdibm-c -o {1}", "report {1} -o {1}-page",
          "query {0} --methods tdibm-c --json", "import {0} -o {1}.jsonl", "verify {0}"}) {
      const Finished finished =
          shell(fmt::format("cd {}; $ccdfuzz {} > out", folder.path(),
                            fmt::format(fmt::runtime(command), name + "-vertex-face.csv", name)));
      EXPECT_EQ(finished.code, 0) << command << finished.err;
      bytes.push_back(finished.peak_bytes);
    }
    return bytes;
  };
  const std::vector<std::uint64_t> few = peaks("few", kFew), many = peaks("many", kMany);
  // A query as a case with its rows takes some 4 KB.
  for (size_t i = 0; i < few.size(); ++i) EXPECT_LT(many[i], few[i] + kMany * 1'000) << i;
}

}  // namespace
}  // namespace ccdfuzz
