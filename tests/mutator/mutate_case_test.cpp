#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "bases.hpp"
#include "ccd/witness_trace/trace.hpp"
#include "fuzz/mutator/mutate.hpp"
#include "fuzz/unproven.hpp"
#include "method/method_set.hpp"
#include "scratch_folder.hpp"
#include "share.hpp"

extern "C" {
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1,
                                      const std::uint8_t* data2, std::size_t size2,
                                      std::uint8_t* out, std::size_t max_size, unsigned int seed);

// In place of libFuzzer's: it may write anything.
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size) {
  std::fill_n(data, size, static_cast<std::uint8_t>(0xA5));
  if (size < max_size) data[size++] = 0xA5;
  return size;
}
}

namespace ccdfuzz {
namespace {

constexpr std::size_t kMaxSize = 8192;
constexpr std::uint8_t kMethod = 4;

std::vector<std::uint8_t> mutant_of(const Contact& q, unsigned seed, std::uint64_t own_in) {
  std::vector<std::uint8_t> bytes = to_bytes(q, kMethod).value();
  const std::size_t size = bytes.size();
  bytes.resize(kMaxSize);
  bytes.resize(mutate_case(bytes.data(), size, kMaxSize, seed,
                           {.own_in = own_in, .methods = kUnproven.size()}));
  return bytes;
}

class MutateCase : public testing::TestWithParam<std::uint64_t> {};

TEST_P(MutateCase, KeepsTheMethodSevenTimesInEight) {
  const std::vector<Contact> bases = mutation_bases();
  constexpr unsigned kTries = 4000 / kOneIn;
  std::array<unsigned, kUnproven.size()> with_method{};
  for (unsigned seed = 1; seed <= kTries; ++seed) {
    const auto mutant = mutant_of(bases[seed % bases.size()], seed, GetParam());
    ASSERT_GT(mutant.size(), 1U);
    ASSERT_LT(mutant[0], kUnproven.size());
    ++with_method[mutant[0]];
  }
  EXPECT_GE(with_method[kMethod], kTries * 80 / 100);
  EXPECT_LE(with_method[kMethod], kTries * 93 / 100);
  for (const unsigned count : with_method) EXPECT_GT(count, 0U);
}

// The fuzzer's own moves each time, or never in practice.
INSTANTIATE_TEST_SUITE_P(OwnMoves, MutateCase, testing::Values(1, 1'000'000));

// libFuzzer begins with a line feed where it has no corpus.
TEST(MutateCase, AnInputThatNamesNoMethodIsGivenAnyOne) {
  std::array<unsigned, kUnproven.size()> with_method{};
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::vector<std::uint8_t> bytes(kMaxSize, '\n');
    bytes.resize(mutate_case(bytes.data(), 1, kMaxSize, seed, {.methods = kUnproven.size()}));
    ASSERT_LT(method_number(bytes), kUnproven.size());
    ++with_method[method_number(bytes)];
  }
  for (const unsigned count : with_method) EXPECT_GT(count, 0U);
}

TEST(MutateCase, AnInputThatIsNoneBecomesOne) {
  std::vector<std::uint8_t> bytes(kMaxSize);
  bytes.resize(mutate_case(bytes.data(), 0, kMaxSize, 1, {.own_in = 1, .methods = 1}));
  EXPECT_TRUE(contact_of_bytes(bytes));
  EXPECT_EQ(method_number(bytes), 0);
}

/// The pairs of kinds of shapes that mutants of these bytes have.
std::set<std::array<ShapeKind, 2>> kinds_from(const std::vector<std::uint8_t>& parent) {
  std::set<std::array<ShapeKind, 2>> kinds;
  for (unsigned seed = 1; seed <= 4000; ++seed) {
    std::vector<std::uint8_t> bytes = parent;
    bytes.resize(kMaxSize);
    bytes.resize(mutate_case(bytes.data(), parent.size(), kMaxSize, seed));
    const std::optional<Contact> mutant = contact_of_bytes(bytes);
    if (!mutant) continue;
    const auto& [a, b] = mutant->query.patches;
    kinds.insert({a.shape.kind, b.shape.kind});
  }
  return kinds;
}

TEST(MutateCase, AnEmptyCorpusReachesAllShapes) {
  constexpr std::size_t kPairs = 16;  // of points, curves, triangles and tensor patches
  EXPECT_EQ(kinds_from({'\n'}).size(), kPairs);
  EXPECT_EQ(kinds_from(to_bytes(falling_point()).value()).size(), kPairs);
}

TEST(MutateCase, AnInputFitsWhereNoDrawnContactDoes) {
  const std::size_t small = to_bytes(falling_point()).value().size();
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::vector<std::uint8_t> bytes(small);
    bytes.resize(mutate_case(bytes.data(), 0, small, seed));
    EXPECT_TRUE(bytes.empty() || contact_of_bytes(bytes));
  }
}

TEST(CrossOver, KeepsTheMethodOfTheFirst) {
  const std::vector<Contact> bases = mutation_bases();
  const auto mother = to_bytes(bases[0], kMethod).value(), father = to_bytes(bases[1], 1).value();
  unsigned children = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::vector<std::uint8_t> child(kMaxSize);
    child.resize(LLVMFuzzerCustomCrossOver(mother.data(), mother.size(), father.data(),
                                           father.size(), child.data(), kMaxSize, seed));
    if (child.empty()) continue;
    ++children;
    ASSERT_EQ(method_number(child), kMethod);
  }
  EXPECT_GT(children, 0U);
}

// It stands before what runs the target without CCDFUZZ_LOST.
TEST(WitnessedTarget, KeepsWhatTheMethodLosesThatTheFirstByteNames) {
  const ScratchFolder folder;
  ::setenv("CCDFUZZ_LOST", folder.path().c_str(), 1);
  const std::vector<Contact> bases = mutation_bases();
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const auto bytes = mutant_of(bases[seed % bases.size()], seed, 1000);
    EXPECT_LE(LLVMFuzzerTestOneInput(bytes.data(), bytes.size()), 0);
  }
  MethodSet methods;
  std::set<std::size_t> kept;
  for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
    const std::string text = read_text(file.path());
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    const Contact q = contact_of_bytes(bytes, QueryRange::kAll).value();
    const std::size_t method = *kept.insert(unproven_of(bytes)).first;
    EXPECT_TRUE(methods[kUnproven[method]].trace(q.query, q.witness(), {}).lost) << file;
  }
  EXPECT_GE(kept.size(), 2U);
}

TEST(WitnessedTarget, ReadsAnyFirstByte) {
  const auto bytes = to_bytes(falling_point(), 255).value();
  EXPECT_LT(unproven_of(bytes), kUnproven.size());
  EXPECT_EQ(LLVMFuzzerTestOneInput(bytes.data(), bytes.size()), 0);
}

}  // namespace
}  // namespace ccdfuzz
