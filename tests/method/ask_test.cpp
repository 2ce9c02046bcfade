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

Outcome outcome_of(std::optional<double> toi, double tolerance) {
  Says method(toi, tolerance);
  return ask(method, falling_ball(), {}).outcome;
}

TEST(Ask, HoldsNoOverlapOfBodiesWithinTheToleranceAgainstAMethod) {
  EXPECT_EQ(outcome_of(1.0, 0), Outcome::kCorrect);
  EXPECT_EQ(outcome_of(1.125, 0), Outcome::kLate);
  EXPECT_EQ(outcome_of(1.125, 0.125), Outcome::kCorrect);
  EXPECT_EQ(outcome_of(1.125, 0.12), Outcome::kLate);
  EXPECT_EQ(outcome_of({}, 0.99), Outcome::kMissed) << "it passes by 1 into the box";
  EXPECT_EQ(outcome_of({}, 1), Outcome::kCorrect);
}

}  // namespace
}  // namespace ccdfuzz
