// The finds that stand in corpus/engines are such that people take them for what they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "certify/checker/check_case.hpp"
#include "files/check_file.hpp"
#include "method/domain.hpp"
#include "numeric/dyadic.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;

/// The most bits that any number of a query has from its first to its last 1.
size_t most_bits(const Query& query) {
  size_t most = 0;
  const auto count = [&](double x) {
    const Integer mantissa = Dyadic::exact(x).mantissa();
    if (mantissa != 0) most = std::max(most, mpz_sizeinbase(mantissa.get_mpz_t(), 2));
  };
  for (const MovingPatch<double>& patch : query.patches) for_each_coordinate(patch, count);
  count(query.t_max);
  return most;
}

TEST(EngineFinds, AreRegularAndOfFewDigits) {
  const std::vector<fs::path> overlapping{"fcl-bodies", "jolt", "physx", "rapier", "rapier2d"};
  for (const auto& engine : fs::directory_iterator(CCDFUZZ_SOURCE_DIR "/corpus/engines")) {
    if (engine.path().filename() == "tight-inclusion") continue;  // whose finds are of rounding
    std::vector<size_t> bits;
    double regular = 0;
    for (const auto& file : fs::directory_iterator(engine)) {
      if (file.is_directory()) continue;
      const Result<NamedCase> read = read_checked_case(file.path());
      ASSERT_TRUE(read) << file.path();
      const Case& found = read->value;
      Domain promised;
      promised.scale = is_of_bodies(found.query) ? 7 : 14;
      promised.binary32 = is_of_bodies(found.query);
      promised.ordinary = true;
      promised.initial_overlap = std::ranges::count(overlapping, engine.path().filename()) > 0;
      promised.plane = engine.path().filename().string().ends_with("2d");
      const std::string broken = promised.broken_by(found);
      if (!broken.empty()) std::cout << file.path() << ": " << broken << "\n";
      regular += broken.empty() ? 1 : 0;
      bits.push_back(most_bits(found.query));
    }
    if (bits.empty()) continue;
    std::ranges::sort(bits);
    EXPECT_GE(regular / static_cast<double>(bits.size()), 0.8) << engine.path();
    EXPECT_LE(bits[bits.size() / 2], 12U) << engine.path();
  }
}

/// Reading a case checks its proof.
TEST(ReportedCases, AreProvenAndNameTheirThreadAndVersions) {
  int count = 0;
  for (const auto& file : fs::recursive_directory_iterator(CCDFUZZ_SOURCE_DIR "/corpus/engines")) {
    if (file.path().parent_path().filename() != "reported") continue;
    const Result<NamedCase> read = read_checked_case(file.path());
    ASSERT_TRUE(read) << file.path();
    const CheckedCase known = checked_or_unknown(read->value);
    EXPECT_TRUE(known.collides()) << file.path();
    EXPECT_TRUE(known.value().origin.note.starts_with("https://github.com/")) << file.path();
    EXPECT_FALSE(known.value().expect.empty()) << file.path();
    ++count;
  }
  EXPECT_GE(count, 6);
}

}  // namespace
}  // namespace ccdfuzz
