// What a query may take: memory by counted allocations, time by a counted clock.
#include <gtest/gtest.h>

#include <array>

#include "allocations.hpp"
#include "ccd/rational/proves_clear.hpp"
#include "ccd/search_queue.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/draw_patch.hpp"
#include "generators/generate.hpp"
#include "method/method.hpp"
#include "numeric/block_array.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

/// Two patches of one shape, at rest, `gap` apart in z and else the same: until cells are smaller
/// than the gap, each cell of one meets its neighbours of the other.
Query parallel(const Shape& shape, double gap) {
  Query query;
  for (size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    patch.shape = shape;
    for_each_control(shape, [&](int i, int j) {
      const double u = i / 8.0, v = j / 8.0;
      patch.positions.push_back({u, v, u * v + (s == 0 ? 0 : gap)});
      patch.velocities.push_back({0, 0, 0});
    });
  }
  query.t_max = 1;
  return query;
}

constexpr std::uint64_t kBudget = 20 << 20;
/// What SearchOptions says of the peak.
constexpr long kMostHeld = (kBudget + kBudget / 6 + SearchOptions::kGrowthBytes) + (12 << 20);

struct Spent {
  Answer answer;
  long peak, kept;
};

Spent ask(Method& method, const Query& query) {
  SearchOptions options;
  options.precision = 0x1p-30;
  options.max_bytes = kBudget;
  options.max_pops = 10'000'000;
  const long before = allocated_bytes();
  begin_peak();
  Answer answer = method.answer(query, options);
  return {std::move(answer), peak_allocated_bytes() - before, allocated_bytes() - before};
}

TEST(Memory, PeakStaysWithinTheBudgetAndLittleIsKept) {
  const auto method = *make_method("tdibm-c");
  const Spent large = ask(*method, parallel(Shape::triangle(2), 0x1p-28));
  EXPECT_EQ(large.answer.note, "memory budget exhausted");
  EXPECT_GE(large.peak, static_cast<long>(kBudget)) << "the query was too small";
  EXPECT_LE(large.peak, kMostHeld);
  EXPECT_LE(large.kept, static_cast<long>(kKeptBytes));

  // What is kept of one query counts for the next, of a shape whose cells are larger.
  const Spent next = ask(*method, parallel(Shape::tensor(8, 8), 0x1p-28));
  EXPECT_EQ(next.answer.note, "memory budget exhausted");
  EXPECT_LE(next.peak + large.kept, kMostHeld);
  EXPECT_LE(next.kept + large.kept, static_cast<long>(kKeptBytes));
}

/// Regular contacts of two faces of the shape, at a separation. One in a hundred takes more.
void expect_few_pops_apart(const char* method_name, const Shape& shape) {
  const auto method = *make_method(method_name);
  GeneratorOptions options{.family = Family::kSeparated, .shapes = std::array{shape, shape}};
  options.seed = test_seed();
  int many = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Case apart = generate(options, i).value;
    const Answer answer = method->answer(apart.query, {.max_pops = 2000});
    EXPECT_NE(answer.verdict, Verdict::kMiss) << i << " of " << to_text(apart.query);
    many += answer.verdict == Verdict::kHit ? 0 : 1;
  }
  EXPECT_LE(many, 4) << to_text(shape);
}

TEST(Pops, AreFewAtASeparationThoughTheWindowGoesOnAfterTheContact) {
  expect_few_pops_apart("tdibm-c", Shape::tensor(2, 2));
  expect_few_pops_apart("tdibm-rational", Shape::tensor(1, 1));
}

TEST(Pops, AreFewAtASeparationWhereAnAreaComesNearAtOneTime) {
  expect_few_pops_apart("tdibm-rational", Shape::triangle(1));
}

struct Numbered {
  std::uint64_t number;
  std::array<std::uint64_t, 8> ballast;
  static bool later(const Numbered& x, const Numbered& y) { return x.number > y.number; }
};

TEST(SearchQueue, GrowsWithoutACopyAndTakesInOrder) {
  constexpr std::uint64_t kCount = 100'000;
  const long before = allocated_bytes();
  begin_peak();
  SearchQueue<Numbered> queue;
  for (std::uint64_t i = 0; i < kCount; ++i) queue.push({i * 77'773 % kCount, {}});
  EXPECT_EQ(queue.bytes(), kCount * sizeof(Numbered));
  EXPECT_LE(peak_allocated_bytes() - before, static_cast<long>(queue.bytes() + (128 << 10)));
  for (std::uint64_t i = 0; i < kCount; ++i) ASSERT_EQ(queue.pop().number, i);
  EXPECT_TRUE(queue.empty());
  queue.keep_at_most(1 << 20);
  EXPECT_LE(queue.held(), 1U << 20);
  EXPECT_LE(allocated_bytes() - before, (1 << 20) + (64 << 10));
}

TEST(Memory, AThreadThatDecidesKeepsLittle) {
  const long before = allocated_bytes();
  OracleOptions options;
  options.max_pops = 3'000;
  options.max_tree_nodes = 100;
  decide(parallel(Shape::tensor(3, 3), 0x1p-28), options);
  proves_clear(parallel(Shape::triangle(2), 0x1p-20), 1, {.pops = 300});
  EXPECT_LE(allocated_bytes() - before, static_cast<long>(3 * kKeptBytes));
}

double reads = 0;
double counted_clock() {
  return ++reads;
}

Answer ask_by_clock(const char* spec, const Query& query, double max_seconds) {
  reads = 0;
  SearchOptions options;
  options.precision = 0x1p-30;
  options.max_pops = 200;
  options.max_seconds = max_seconds;
  options.clock = counted_clock;
  return (*make_method(spec))->answer(query, options);
}

TEST(TimeLimit, EndsWhilePairsAreSplit) {
  const Answer answer = ask_by_clock("tdibm-rational", parallel(Shape::tensor(8, 8), 0x1p-28), 9.5);
  EXPECT_EQ(answer.verdict, Verdict::kUndecided);
  EXPECT_EQ(answer.note, "time budget exhausted");
  EXPECT_EQ(reads, 11) << "one at the beginning, one a test of 162 control points";
  EXPECT_EQ(answer.pops, 1U);
  EXPECT_EQ(answer.toi, 0.0);
}

TEST(TimeLimit, IsLookedAtOncePerPairOfLargePatches) {
  const Answer answer = ask_by_clock("tdibm-c", parallel(Shape::tensor(8, 8), 0x1p-28), 20.5);
  EXPECT_EQ(answer.note, "time budget exhausted");
  EXPECT_LE(answer.pops, 21U);
}

TEST(TimeLimit, EndsTheOraclesSearchesAndTrees) {
  const Answer answer = ask_by_clock("oracle", parallel(Shape::tensor(8, 8), 0x1p-28), 20.5);
  EXPECT_EQ(answer.verdict, Verdict::kUndecided);
  EXPECT_EQ(answer.note, "time budget exhausted");
  EXPECT_LE(answer.pops, 25U);
  EXPECT_LE(reads, 100) << "each search and each tree that is not begun any more reads a few times";
}

TEST(TimeLimit, CostsFewLooksWhereTestsAreQuick) {
  for (const char* spec : {"tdibm", "tdibm-c"}) {
    const Answer answer = ask_by_clock(spec, parallel(Shape::triangle(2), 0x1p-28), 1e9);
    EXPECT_EQ(answer.pops, 200U) << spec;
    EXPECT_LE(reads, 1 + 2 * static_cast<double>(answer.pops)) << spec;
    EXPECT_GT(reads, 5) << spec;
  }
}

}  // namespace
}  // namespace ccdfuzz
