#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ccd/random_query.hpp"
#include "ccd/rational/pair_test.hpp"
#include "ccd/witness_trace/inclusion_tracer.hpp"
#include "share.hpp"
#include "traced.hpp"

namespace ccdfuzz {
namespace {

TEST(Trace, TheSoundMethodsLoseNoWitnessOfAnyClassAndFamily) {
  for (const std::string& spec : kSound) {
    const auto tracer = tracer_of(spec);
    for (const ContactClass contact : kContactClasses) {
      for (const Family family : kFamilies) {
        if (!is_made(family, contact, CaseKind::kRP)) continue;
        for (std::uint64_t index = 0; index < 5; index += kOneIn) {
          const Case known = generated_case(contact, family, index);
          const Trace& trace = tracer->trace(known.query, *known.truth.witness, {.all = true});
          ASSERT_FALSE(trace.lost)
              << fmt::format("{}: {} {} {}, level {}, axis {}", spec, name_of(contact),
                             name_of(family), index, trace.loss->place.level, trace.loss->by.axis);
          EXPECT_EQ(trace.false_claims, 0U);
          const auto& patches = known.query.patches;
          const bool is_split = spec != std::string_view("tdibm-c") ||
                                !is_linear_pair(patches[0].shape, patches[1].shape);
          EXPECT_EQ(trace.levels, is_split ? depth_for(1e-4) : 0);
        }
      }
    }
  }
}

TEST(Trace, ContactsAtTheEndsOfTheStepSurvive) {
  Query parting = meeting_points(1);
  parting.patches[1].positions[0] = {0, 0, 0};
  for (const std::string& spec : every_method_but()) {
    const auto tracer = tracer_of(spec);
    // Not tdibm-h:F: what has no size is not pulled apart, but neither is it lost here.
    EXPECT_FALSE(tracer->trace(meeting_points(.5), at_time(Rational(1, 2)), {}).lost) << spec;
    EXPECT_FALSE(tracer->trace(parting, at_time(0), {}).lost) << spec;
    parting.t_max = 0;
    EXPECT_FALSE(tracer->trace(parting, at_time(0), {}).lost) << spec;
    parting.t_max = 1;
  }
}

TEST(Trace, FollowsAllCellsThatMeetInTheWitness) {
  struct Expected {
    Shape shape;
    Rational u, v;
    std::uint64_t cells;          ///< that meet in (u, v) from level 3 on
    std::uint64_t first, second;  ///< on levels 1 and 2
  };
  const std::array expected = {
      Expected{Shape::curve(3), Rational(1, 2), 0, 2, 2, 2},
      Expected{Shape::curve(3), Rational(1, 3), 0, 1, 1, 1},
      Expected{Shape::tensor(2, 2), Rational(1, 2), Rational(1, 2), 4, 4, 4},
      Expected{Shape::triangle(2), Rational(1, 2), Rational(1, 2), 3, 3, 3},
      Expected{Shape::triangle(2), Rational(1, 4), Rational(1, 4), 6, 2, 6},
      Expected{Shape::triangle(2), 0, 0, 1, 1, 1},
  };
  for (const char* spec : {"tdibm", "tdibm-e", "tdibm-rational", "tdibm-c"}) {
    const auto tracer = tracer_of(spec);
    for (const Expected& e : expected) {
      SCOPED_TRACE(fmt::format("{} {} {} {}", spec, to_text(e.shape), to_text(e.u), to_text(e.v)));
      Witness witness;
      witness.t = Rational(1, 3);
      witness.uv = {Uv<Rational>{e.u, e.v}, Uv<Rational>{e.u, e.v}};
      const Query query = twice_the_same(e.shape);
      const std::uint64_t whole = std::string(spec) == "tdibm-c" ? 0 : 1;
      const Trace one = tracer->trace(query, witness, {.precision = 0x1p-5});
      EXPECT_FALSE(one.lost);
      EXPECT_EQ(one.pairs, whole + 5);
      const Trace all = tracer->trace(query, witness, {.precision = 0x1p-5, .all = true});
      EXPECT_FALSE(all.lost);
      EXPECT_EQ(all.pairs, whole + e.first * e.first + e.second * e.second + 3 * e.cells * e.cells);
    }
  }
}

TEST(Trace, BothHalvesOfAWindowContainItsMiddle) {
  const auto tracer = tracer_of("trad");
  const Query query = meeting_points(1);
  const Trace one = tracer->trace(query, at_time(Rational(1, 2)), {.precision = .25});
  const Trace all = tracer->trace(query, at_time(Rational(1, 2)), {.precision = .25, .all = true});
  EXPECT_FALSE(all.lost);
  EXPECT_EQ(one.pairs, 3U);
  EXPECT_EQ(all.pairs, 1U + 2 + 2);
}

TEST(Trace, FollowsOneHalfOfAWindowOfOneTime) {
  const auto tracer = tracer_of("trad");
  Query query = meeting_points(1);
  query.patches[1].positions[0] = {0, 0, 0};
  query.t_max = 0;
  const Trace all = tracer->trace(query, at_time(0), {.precision = 0x1p-20, .all = true});
  EXPECT_EQ(all.pairs, 21U);
}

/// The exact inclusion test with a fault: from a depth on it takes one double too much.
class OneUlpTooMuch {
 public:
  static constexpr int kFrom = 4;

  void begin(const Query& query) { test_.begin(query); }
  void prepare(int side, std::span<const Cell> parts) {
    depth_ = parts[0].depth;
    test_.prepare(side, parts);
  }
  std::optional<Window> test(int a, int b, const Window& window, ExclusionObserver* observer) {
    auto left = test_.test(a, b, window, observer);
    if (!left || depth_ < kFrom) return left;
    const double hi = std::nextafter(left->hi, 0.);
    observer->excluded({77, {0, 0, 1}, 1, {hi, left->hi, false, true}});
    return Window{left->lo, hi};
  }

 private:
  exact_ccd::PairTest test_;
  int depth_ = 0;
};

TEST(Trace, APlantedFaultOfOneUlpIsFoundWhereItIs) {
  InclusionTracer<OneUlpTooMuch> tracer;
  for (const ContactClass contact : kContactClasses) {
    const Case known = generated_case(contact, Family::kRegular, 0);
    const Trace& trace = tracer.trace(known.query, *known.truth.witness, {});
    ASSERT_TRUE(trace.lost) << name_of(contact);
    EXPECT_EQ(trace.loss->place.level, OneUlpTooMuch::kFrom);
    EXPECT_EQ(trace.loss->by.axis, 77);
    EXPECT_EQ(trace.loss->by.below, 1);
    EXPECT_EQ(trace.loss->place.window.hi, known.query.t_max);
    ASSERT_TRUE(trace.loss->left);
    EXPECT_EQ(trace.loss->left->hi, std::nextafter(known.query.t_max, 0.));
    EXPECT_EQ(trace.lost_pairs, 1U);
    EXPECT_EQ(trace.margin->ulps, 0U);
    EXPECT_GT(trace.false_claims, 0U);
  }
}

// The steps tell the same story as the trace, pair by pair.
TEST(Trace, StepsAreThePairsOfTheTrace) {
  for (const std::string& spec : every_method_but()) {
    for (const ContactClass contact : {ContactClass::kVV, ContactClass::kEE}) {
      const Case known = generated_case(contact, Family::kRegular, 3);
      const auto tracer = tracer_of(spec);
      const TraceOptions with_steps{1e-4, false, true};
      const Trace trace = tracer->trace(known.query, *known.truth.witness, with_steps);
      ASSERT_EQ(trace.steps.size(), trace.pairs) << spec;
      std::optional<std::uint64_t> least;
      for (const Trace::Step& step : trace.steps) {
        const bool here = trace.loss && trace.loss->place.level == step.place.level;
        EXPECT_EQ(step.lost, here) << spec << " at level " << step.place.level;
        if (step.margin) least = std::min(least.value_or(step.margin->ulps), step.margin->ulps);
      }
      EXPECT_EQ(least.has_value(), trace.margin.has_value()) << spec;
      if (least) {
        EXPECT_EQ(*least, trace.margin->ulps) << spec;
      }
      EXPECT_TRUE(tracer->trace(known.query, *known.truth.witness, {}).steps.empty()) << spec;
    }
  }
}

}  // namespace
}  // namespace ccdfuzz
