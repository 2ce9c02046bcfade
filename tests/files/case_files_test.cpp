#include "files/case_files.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "files/case_json.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;

Case simple_case(double x = 1) {
  Case c;
  for (MovingPatch<double>& patch : c.query.patches) {
    patch = {Shape::point(), {{x, 0, 0}}, {{0, 0, 0}}};
  }
  return c;
}

Result<std::vector<NamedCase>> read_cases(const std::string& path) {
  std::vector<NamedCase> cases;
  for (CaseStream stream({path});;) {
    CCDFUZZ_TRY(auto next, stream.next());
    if (!next) return cases;
    cases.push_back(*std::move(next));
  }
}

std::string error_of(const std::string& path) {
  const auto cases = read_cases(path);
  return cases ? "no error" : cases.error().message();
}

Result<void> write_cases(const std::string& path, const std::vector<Case>& cases) {
  auto writer = CaseWriter::open(path);
  if (!writer) return tl::unexpected(writer.error());
  for (const Case& c : cases) {
    if (auto written = writer->write(c); !written) return written;
  }
  return writer->finish();
}

class DataSet : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Endings, DataSet, testing::Values("d.jsonl", "d.jsonl.zst"));

TEST_P(DataSet, RoundTripsAndNamesLines) {
  const ScratchFolder folder;
  const std::string path = folder / GetParam();
  std::vector<Case> cases;
  for (int i = 0; i < 3000; ++i) cases.push_back(simple_case(i / 3.0));
  ASSERT_TRUE(write_cases(path, cases));
  const auto back = read_cases(path);
  ASSERT_TRUE(back) << back.error().message();
  ASSERT_EQ(back->size(), cases.size());
  for (size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ((*back)[i].value, cases[i]);
    EXPECT_EQ((*back)[i].id, path + ":" + std::to_string(i + 1));
  }
  EXPECT_EQ(folder.entry_count(), 1U);
}

TEST_P(DataSet, WritesTheSameBytesAgain) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_cases(folder / std::string("a") + GetParam(), {simple_case(), simple_case(2)}));
  ASSERT_TRUE(write_cases(folder / std::string("b") + GetParam(), {simple_case(), simple_case(2)}));
  EXPECT_EQ(read_text(folder / std::string("a") + GetParam()),
            read_text(folder / std::string("b") + GetParam()));
}

TEST_P(DataSet, AppearsOnlyWhenFinished) {
  const ScratchFolder folder;
  const std::string path = folder / GetParam();
  ASSERT_TRUE(write_cases(path, {simple_case(7)}));
  {
    auto writer = CaseWriter::open(path);
    ASSERT_TRUE(writer);
    for (int i = 0; i < 3000; ++i) ASSERT_TRUE(writer->write(simple_case(i)));
    EXPECT_EQ(read_cases(path)->size(), 1U);
  }
  EXPECT_EQ(read_cases(path)->at(0).value, simple_case(7));
  EXPECT_EQ(folder.entry_count(), 1U);
}

TEST_P(DataSet, FullDiskIsAnError) {
  const ScratchFolder folder;
  const std::string path = folder / GetParam();
  fs::create_symlink("/dev/full", path);
  const auto written = write_cases(path, {simple_case()});
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message(), path + ": cannot write: No space left on device");
}

TEST(CaseFiles, SingleCaseIsNamedByItsPath) {
  const ScratchFolder folder;
  const std::string path = folder / "c.json";
  ASSERT_TRUE(write_cases(path, {simple_case(0.1)}));
  const auto back = read_cases(path);
  ASSERT_TRUE(back) << back.error().message();
  ASSERT_EQ(back->size(), 1U);
  EXPECT_EQ(back->at(0).id, path);
  EXPECT_EQ(back->at(0).value, simple_case(0.1));
}

TEST(CaseFiles, BlankLinesCarriageReturnsAndByteOrderMarkAreTolerated) {
  const ScratchFolder folder;
  const std::string line = to_json(simple_case());
  write_text(folder / "c.jsonl", "\xef\xbb\xbf" + line + "\r\n\r\n  \n" + line);
  const auto back = read_cases(folder / "c.jsonl");
  ASSERT_TRUE(back) << back.error().message();
  ASSERT_EQ(back->size(), 2U);
  EXPECT_EQ(back->at(1).id, folder / "c.jsonl:4");
  write_text(folder / "c.json", "\xef\xbb\xbf\r\n" + line + "\r\n");
  EXPECT_EQ(read_cases(folder / "c.json")->size(), 1U);
}

TEST(CaseFiles, TruncatedAndCorruptZstdAreErrorsAtEveryLength) {
  const ScratchFolder folder;
  std::vector<Case> cases;
  for (int i = 0; i < 50; ++i) cases.push_back(simple_case(i / 3.0));
  ASSERT_TRUE(write_cases(folder / "d.jsonl.zst", cases));
  const std::string whole = read_text(folder / "d.jsonl.zst");
  const std::string cut = folder / "cut.jsonl.zst";
  for (size_t n = 1; n < whole.size(); ++n) {
    write_text(cut, whole.substr(0, n));
    EXPECT_EQ(error_of(cut), cut + ": is truncated: its zstd data end too early") << n;
  }
  write_text(cut, whole + whole);  // frames one after the other are one file
  EXPECT_EQ(read_cases(cut)->size(), 100U);
  std::string corrupt = whole;
  corrupt[corrupt.size() / 2] = static_cast<char>(corrupt[corrupt.size() / 2] ^ 0x10);
  write_text(cut, corrupt);
  EXPECT_THAT(error_of(cut), testing::StartsWith(cut + ": is not sound zstd data: "));
}

TEST(CaseWriter, RefusesWhatItCannotStore) {
  const ScratchFolder folder;
  const auto refused = [&](const std::string& name, const std::vector<Case>& cases) {
    const auto written = write_cases(folder / name, cases);
    return written ? "no error" : written.error().message().substr(folder.path().size() + 1);
  };
  EXPECT_EQ(refused("c.txt", {simple_case()}), "c.txt: ends in none of .json, .jsonl, .jsonl.zst");
  EXPECT_EQ(refused("c.json", {simple_case(), simple_case()}),
            "c.json: a .json file holds one case; .jsonl holds many");
  EXPECT_EQ(refused("c.json", {}), "c.json: no case to write");
  EXPECT_EQ(refused("none/c.json", {simple_case()}),
            "none/c.json: cannot write: No such file or directory");
  fs::create_directory(folder / "d.json");
  EXPECT_EQ(refused("d.json", {simple_case()}), "d.json: cannot write: Is a directory");
  EXPECT_EQ(folder.entry_count(), 1U);
}

TEST(CaseWriter, WritesThroughASymbolicLink) {
  const ScratchFolder folder;
  fs::create_directory(folder / "real");
  write_text(folder / "real/c.json", "old");
  fs::create_symlink("real/c.json", folder / "link.json");
  ASSERT_TRUE(write_cases(folder / "link.json", {simple_case()}));
  EXPECT_TRUE(fs::is_symlink(folder / "link.json"));
  EXPECT_EQ(read_cases(folder / "real/c.json")->at(0).value, simple_case());
}

}  // namespace
}  // namespace ccdfuzz
