#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "ccd/rational/pair_test.hpp"
#include "ccd/tdibm.hpp"
#include "ccd/traditional.hpp"
#include "ccd/witness_trace/certified_tracer.hpp"
#include "ccd/witness_trace/inclusion_tracer.hpp"
#include "traced.hpp"

namespace ccdfuzz {
namespace {

/// What an inclusion test was asked, and what it answered.
using Asked = std::tuple<std::array<std::uint64_t, 8>, double, double>;
using Record = std::map<Asked, std::optional<std::pair<double, double>>>;

/// An inclusion test that writes down every question and answer.
template <class Inclusion>
class Recording {
 public:
  template <class... Args>
  explicit Recording(Record& record, Args&&... args)
      : record_(record), inner_(std::forward<Args>(args)...) {}

  void begin(const Query& query) { inner_.begin(query); }
  void prepare(int side, std::span<const Cell> parts) {
    std::copy(parts.begin(), parts.end(), parts_[static_cast<size_t>(side)].begin());
    inner_.prepare(side, parts);
  }
  std::optional<Window> test(int a, int b, const Window& w, ExclusionObserver* observer = nullptr) {
    const auto left = inner_.test(a, b, w, observer);
    const Cell &x = parts_[0][static_cast<size_t>(a)], &y = parts_[1][static_cast<size_t>(b)];
    const auto depth = [](const Cell& c) { return static_cast<std::uint64_t>(c.depth); };
    auto& out =
        record_[{{x.i, x.j, depth(x), x.inverted, y.i, y.j, depth(y), y.inverted}, w.lo, w.hi}];
    if (left) out = {left->lo, left->hi};
    return left;
  }

 private:
  Record& record_;
  Inclusion inner_;
  std::array<std::array<Cell, 4>, 2> parts_;
};

// A trace asks the inclusion test nothing that a full search would not ask, and gets the same
// answers. A search ends with the first hit: pairs it had not come to by then, it did not ask
// about.
template <class Inclusion, class... Args>
void expect_the_trace_within_the_search(const Args&... args) {
  size_t same = 0;
  for (const ContactClass contact : kContactClasses) {
    for (std::uint64_t index = 0; index < 6; ++index) {
      const Case known =
          generated_case(contact, index % 2 == 0 ? Family::kRegular : Family::kInteriorTime, index);
      constexpr double kPrecision = 0x1p-5;
      Record searched, traced;
      SearchOptions limits;
      limits.precision = kPrecision;
      limits.max_pops = 20000;
      Search<Recording<Inclusion>> search(searched, args...);
      const Answer answer = search.answer(known.query, limits);
      InclusionTracer<Recording<Inclusion>> tracer(traced, args...);
      const Trace& trace =
          tracer.trace(known.query, *known.truth.witness, {.precision = kPrecision, .all = true});
      EXPECT_EQ(trace.pairs, traced.size());
      for (const auto& [asked, told] : traced) {
        const auto found = searched.find(asked);
        if (found == searched.end()) {
          ASSERT_TRUE(answer.toi) << "a miss has asked about every pair";
          ASSERT_GE(std::get<1>(asked), 0);
          continue;
        }
        ASSERT_EQ(found->second, told) << name_of(contact) << ' ' << index;
        ++same;
      }
      // The first split is always made.
      EXPECT_TRUE(searched.contains(traced.begin()->first));
    }
  }
  EXPECT_GT(same, 60U) << "too little was compared";
}

TEST(FullSearch, TestsTheTracedPairsOfThePaperMethods) {
  expect_the_trace_within_the_search<TdibmInclusion<Plain>>(Plain());
  expect_the_trace_within_the_search<TdibmInclusion<PullApart>>(PullApart(1e-12));
  expect_the_trace_within_the_search<TdibmInclusion<ErrorBoundIntended>>(ErrorBoundIntended());
}

TEST(FullSearch, TestsTheTracedPairsOfTheTraditionalMethod) {
  expect_the_trace_within_the_search<TraditionalInclusion>(BoxKind::kAxisAligned);
}

TEST(FullSearch, TestsTheTracedPairsOfTheRationalMethod) {
  expect_the_trace_within_the_search<exact_ccd::PairTest>();
}

/// What a split keeps of a pair's children, by their cells.
std::map<std::array<certified::CellTree::Node, 2>, certified::CellPair> kept_of(
    certified::PairSplit& split, const certified::CellPair& parent,
    const std::array<unsigned, 2>& wanted, ExclusionObserver* observer) {
  std::array<certified::CellPair, certified::PairSplit::kMostPairs> kept;
  const int count = split.split(parent, wanted, kept, observer);
  std::map<std::array<certified::CellTree::Node, 2>, certified::CellPair> out;
  for (const auto& pair : std::span(kept).first(static_cast<size_t>(count))) out[pair.cells] = pair;
  return out;
}

class Deaf : public ExclusionObserver {
 public:
  void excluded(const ExcludedInterval&) override {}
  void compared(const SignedGap&) override {}
};

// The certified method looks at all children of a pair, a trace at one of each patch.
TEST(FullSearch, SplitsOfTheCertifiedMethodGiveEachPairTheSameWhoeverElseIsThere) {
  size_t same = 0;
  for (std::uint64_t i = 0; i < 4 * kContactClasses.size(); ++i) {
    const ContactClass contact = kContactClasses[i / 4];
    const Case known = generated_case(contact, Family::kRegular, i % 4);
    certified::PairSplit split;
    constexpr int kFinest = 9;
    split.take(known.query);
    split.begin(kFinest);
    std::vector<certified::CellPair> level = {{{0, split.query().t_max}, {}, {}, {}}};
    for (int depth = 0; depth < kFinest; ++depth) {
      std::vector<certified::CellPair> next;
      for (const auto& parent : level) {
        Deaf listener;
        const auto all = kept_of(split, parent, certified::PairSplit::kAll, nullptr);
        size_t found = 0;
        for (unsigned a = 0; a < 4; ++a) {
          for (unsigned b = 0; b < 4; ++b) {
            for (const auto& [cells, x] : kept_of(split, parent, {1U << a, 1U << b}, &listener)) {
              ASSERT_TRUE(all.contains(cells));
              const auto& y = all.at(cells);
              ASSERT_EQ(x.window.lo, y.window.lo);
              ASSERT_EQ(x.window.hi, y.window.hi);
              ASSERT_EQ(x.hint, y.hint);
              ASSERT_EQ(x.depths, y.depths);
              ++found;
            }
          }
        }
        ASSERT_EQ(found, all.size());
        same += found;
        for (const auto& [cells, kept] : all) next.push_back(kept);
      }
      level = std::move(next);
    }
  }
  EXPECT_GT(same, 500U) << "too little was compared";
}

}  // namespace
}  // namespace ccdfuzz
