#include "method/ask.hpp"

#include <gtest/gtest.h>

#include "case/checked_case.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/oracle.hpp"
#include "method/setting.hpp"

namespace ccdfuzz {
namespace {

/// Says the same of every query, with a tolerance in space.
class Says : public Method {
 public:
  Says(std::optional<double> toi, double tolerance, bool ordinary = false)
      : toi_(toi), tolerance_(tolerance) {
    domain_.ordinary = ordinary;
  }
  const Domain* domain() const override { return &domain_; }
  Answered answer(const Query&, const SearchOptions&) override {
    Answered answered{toi_ ? Answer::hit(*toi_) : Answer::miss()};
    answered.terms.space_tolerance = answered.terms.depth_tolerance = tolerance_;
    return answered;
  }

 private:
  std::optional<double> toi_;
  double tolerance_;
  Domain domain_;
};

/// A ball of radius 1 falls by 1 in each unit of time; it touches a wide box at t = 1.
Case falling_ball() {
  Case value;
  Points<double> corners;
  for (const double x : {-64., 64.}) {
    for (const double y : {-64., 0.}) {
      for (const double z : {-64., 64.}) corners.push_back({x, y, z});
    }
  }
  value.query.patches[0] = {Shape::hull(1), {{0, 2, 0}}, {{0, -1, 0}}, {}, {}, 1};
  value.query.patches[1] = {Shape::hull(8), corners, {{0, 0, 0}}};
  value.query.t_max = 2;
  value.truth.collides = true;
  Witness witness{Rational(1), {}};
  witness.weights[0] = {Rational(1)};
  witness.weights[1] = std::vector<Rational>(8, Rational(0));
  for (const size_t top : {2, 3, 6, 7}) witness.weights[1][top] = Rational(1, 4);
  value.truth.witness = witness;
  return value;
}

Outcome outcome_of(std::optional<double> toi, double tolerance,
                   const Case& known = falling_ball()) {
  Says method(toi, tolerance);
  return ask(method, checked_or_unknown(known), {}).outcome;
}

/// The same with so many points in the place of the ball's centre, and twice as many in the box.
Case falling_points(size_t count) {
  Case value = falling_ball();
  auto& [ball, box] = value.query.patches;
  ball.positions.assign(count, ball.positions[0]);
  ball.shape = Shape::hull(static_cast<int>(count));
  ball.radius = 0;
  box.positions.resize(2 * count, {0, -32, 0});
  box.shape = Shape::hull(static_cast<int>(2 * count));
  value.query.t_max = 4;
  Witness& witness = *value.truth.witness;
  witness.t = 2;
  for (size_t s = 0; s < 2; ++s) {
    witness.weights[s].resize(value.query.patches[s].positions.size(), Rational(0));
  }
  return value;
}

TEST(Ask, HoldsAGrazeOfAMeshAgainstNobodyWhoPromisesOrdinaryQueriesButTheDeepContactBehindIt) {
  // A ball moves along the first triangle, whose edge it touches at t = 4, into the second at 10.
  Case value;
  auto& [mesh, ball] = value.query.patches;
  mesh = {Shape::hull(6),
          {{2, -4, 0}, {2, 4, 0}, {6, 0, 0}, {9, -9, -9}, {9, 9, -9}, {9, 0, 9}},
          {{0, 0, 0}}};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  ball = {Shape::hull(1), {{-2, 0, 1}}, {{1, 0, 0}}, {}, {}, 1};
  value.query.t_max = 16;
  value.truth = decide(value.query).truth;
  ASSERT_EQ(value.truth.witness->t, 4);
  const auto outcome = [&](std::optional<double> toi, double tolerance, bool ordinary) {
    Says method(toi, tolerance, ordinary);
    return ask(method, checked_or_unknown(value), {}).outcome;
  };
  EXPECT_EQ(outcome(10, 0, false), Outcome::kLate);
  EXPECT_EQ(outcome(10, 0.25, false), Outcome::kCorrect);
  EXPECT_EQ(outcome(10, 0, true), Outcome::kCorrect);
  EXPECT_EQ(outcome(4, 0, true), Outcome::kCorrect);
  EXPECT_EQ(outcome(10.5, 0, true), Outcome::kLate);
  EXPECT_EQ(outcome({}, 0, true), Outcome::kMissed);
  EXPECT_EQ(outcome({}, 0.25, true), Outcome::kMissed);
  EXPECT_EQ(setting_of(value), Setting::kOrdinary);
  mesh.faces.pop_back();
  mesh.positions.resize(3);
  mesh.shape = Shape::hull(3);
  value.truth = decide(value.query).truth;
  EXPECT_EQ(setting_of(value), Setting::kSliding);
  EXPECT_EQ(outcome({}, 0, true), Outcome::kNotAsked);
  EXPECT_EQ(outcome({}, 0.25, false), Outcome::kCorrect);
  EXPECT_EQ(outcome({}, 0, false), Outcome::kMissed);
}

/// Hits at 1/2, and claims to be early by so much at most.
class IsEarly : public Method {
 public:
  explicit IsEarly(double by) : by_(by) {}
  Answered answer(const Query&, const SearchOptions&) override {
    Answered answered{Answer::hit(0.5)};
    answered.terms.early_tolerance = by_;
    return answered;
  }

 private:
  double by_;
};

TEST(Ask, AHitAsMuchBeforeALaterContactAsIsClaimedIsNoFalsePositive) {
  Case value;
  value.query.patches[0] = {Shape::point(), {{0.25, 0.25, 1}}, {{0, 0, -1}}};
  value.query.patches[1] = {Shape::triangle(1), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
  value.query.patches[1].velocities.resize(3, {0, 0, 0});
  value.query.t_max = 0.75;
  value.truth = decide(value.query).truth;
  ASSERT_EQ(value.truth.collides, false) << "and of the contact at 1 nothing is said";
  const auto outcome = [&](double by) {
    IsEarly method(by);
    return ask(method, checked_or_unknown(value), {}).outcome;
  };
  EXPECT_EQ(outcome(0), Outcome::kFalsePositive);
  EXPECT_EQ(outcome(0.49), Outcome::kFalsePositive);
  EXPECT_EQ(outcome(0.5), Outcome::kCorrect);
  // Nothing comes after the motion.
  Case ending = value;
  ending.query.t_max = 1;
  ending.query.patches[0].positions[0].z() = 2;
  ending.query.patches[0].velocities.clear();
  ending.query.patches[0].ends = {{0.25, 0.25, 1}};
  std::swap(ending.query.patches[1].ends, ending.query.patches[1].velocities);
  ending.query.patches[1].ends = ending.query.patches[1].positions;
  ending.truth = decide(ending.query).truth;
  std::swap(value, ending);
  EXPECT_EQ(outcome(0.75), Outcome::kFalsePositive);
  std::swap(value, ending);
  // What nobody decides is not held against it, beyond what the certificate says.
  value.query.patches[1] = {
      Shape::triangle(2),
      {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {0, 0.5, 0}, {0.5, 0.5, 0}, {0, 1, 0}},
      {}};
  value.query.patches[1].velocities.resize(6, {0, 0, 0});
  value.truth = decide(value.query).truth;
  ASSERT_EQ(value.truth.collides, false);
  EXPECT_EQ(outcome(0.5), Outcome::kUnknown);
  EXPECT_EQ(outcome(0.125), Outcome::kFalsePositive);
}

TEST(Domain, OfWhatNobodyHasDecidedItIsFoundOutWhetherItIsOrdinary) {
  Query touching;
  touching.patches[0] = {Shape::hull(1), {{0, 0, 1}}, {{0, 0, -1}}};
  touching.patches[1] = {Shape::hull(1), {{0, 0, 0}}, {{0, 0, 0}}};
  touching.patches[0].radius = 0.5;
  const Domain ordinary{.ordinary = true};
  EXPECT_EQ(ordinary.broken_by(Case{touching, {}, {}, {}}), "");
  touching.t_max = 0.5;
  EXPECT_EQ(ordinary.broken_by(Case{touching, {}, {}, {}}),
            "takes ordinary queries, and this is at an end");
}

TEST(Ask, HoldsNoOverlapOfBodiesWithinTheToleranceAgainstAMethod) {
  EXPECT_EQ(outcome_of(1.0, 0), Outcome::kCorrect);
  EXPECT_EQ(outcome_of(1.125, 0), Outcome::kLate);
  EXPECT_EQ(outcome_of(1.125, 0.125), Outcome::kCorrect);
  EXPECT_EQ(outcome_of(1.125, 0.12), Outcome::kLate);
  EXPECT_EQ(outcome_of({}, 0.99), Outcome::kMissed) << "it passes by 1 into the box";
  EXPECT_EQ(outcome_of({}, 1), Outcome::kCorrect);
  Case slow = falling_ball();  // by 1 in 2^600 units of time, the square of which is no double
  slow.query.patches[0].velocities[0][1] = -0x1p-600;
  slow.query.t_max = 0x1p601;
  slow.truth.witness->t = exact(0x1p600);
  EXPECT_EQ(outcome_of({}, 0.99, slow), Outcome::kMissed);
  EXPECT_EQ(outcome_of({}, 1, slow), Outcome::kCorrect);
}

TEST(Ask, ExcusesNoOverlapThatIsNotMeasured) {
  EXPECT_EQ(outcome_of({}, 1, falling_points(4)), Outcome::kMissed) << "2 deep";
  EXPECT_EQ(outcome_of({}, 1, falling_points(13)), Outcome::kUnknown) << "338 pairs of points";
  EXPECT_EQ(outcome_of({}, 0, falling_points(13)), Outcome::kMissed) << "without a tolerance";
  EXPECT_EQ(outcome_of({}, 4, falling_points(13)), Outcome::kCorrect) << "it moves by 4 in all";
}

}  // namespace
}  // namespace ccdfuzz
