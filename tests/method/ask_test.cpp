#include "method/ask.hpp"

#include <gtest/gtest.h>

#include "case/checked_case.hpp"

namespace ccdfuzz {
namespace {

/// Says the same of every query, with a tolerance in space.
class Says : public Method {
 public:
  Says(std::optional<double> toi, double tolerance) : toi_(toi), tolerance_(tolerance) {}
  Answered answer(const Query&, const SearchOptions&) override {
    Answered answered;
    answered.verdict = toi_ ? Verdict::kHit : Verdict::kMiss;
    answered.toi = toi_;
    answered.terms.space_tolerance = tolerance_;
    return answered;
  }

 private:
  std::optional<double> toi_;
  double tolerance_;
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
  return ask(method, known, {}).outcome;
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

TEST(Ask, HoldsNoOverlapOfBodiesWithinTheToleranceAgainstAMethod) {
  EXPECT_EQ(outcome_of(1.0, 0), Outcome::kCorrect);
  EXPECT_EQ(outcome_of(1.125, 0), Outcome::kLate);
  EXPECT_EQ(outcome_of(1.125, 0.125), Outcome::kCorrect);
  EXPECT_EQ(outcome_of(1.125, 0.12), Outcome::kLate);
  EXPECT_EQ(outcome_of({}, 0.99), Outcome::kMissed) << "it passes by 1 into the box";
  EXPECT_EQ(outcome_of({}, 1), Outcome::kCorrect);
}

TEST(Ask, ExcusesNoOverlapThatIsNotMeasured) {
  EXPECT_EQ(outcome_of({}, 1, falling_points(4)), Outcome::kMissed) << "2 deep";
  EXPECT_EQ(outcome_of({}, 1, falling_points(13)), Outcome::kUnknown) << "338 pairs of points";
  EXPECT_EQ(outcome_of({}, 0, falling_points(13)), Outcome::kMissed) << "without a tolerance";
  EXPECT_EQ(outcome_of({}, 4, falling_points(13)), Outcome::kCorrect) << "it moves by 4 in all";
}

}  // namespace
}  // namespace ccdfuzz
