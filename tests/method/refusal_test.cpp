#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "base/verify.hpp"
#include "ccd/rational/proves_clear.hpp"
#include "ccd/witness_trace/trace.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/oracle.hpp"
#include "method/method.hpp"

namespace ccdfuzz {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Every method that can be made, in every form.
std::vector<std::string> every_method() {
  std::vector<std::string> specs = every_method_but();
  for (const std::string& spec : every_method_but()) {
    const std::string unoptimised = spec + kUnoptimised;
    if (make_method(unoptimised)) specs.push_back(unoptimised);
  }
  return specs;
}

/// A corner of one patch falls on the other and meets it at t = 1/2.
Query meeting(const Shape& shape) {
  Query query;
  for (size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    patch.shape = shape;
    for (int i = 0; i < shape.control_count(); ++i) {
      const double z = s == 0 ? 0 : 1;
      patch.positions.emplace_back(i % 3, i / 3, z);
      patch.velocities.emplace_back(0, 0, -2 * z);
    }
  }
  return query;
}

CheckedCase known(const Query& query, const Truth& truth = {}) {
  return checked_or_unknown({query, truth, {}, {}});
}

struct Spoilt {
  std::string note;
  std::function<void(Query&, SearchOptions&)> spoil;
};

/// One field each is set to what it may not be.
std::vector<Spoilt> spoilt_numbers() {
  return {
      {"patches[0].positions[0][2]: nan is not finite",
       [](Query& q, SearchOptions&) { q.patches[0].positions[0][2] = kNan; }},
      {"patches[1].positions[1][1]: -inf is not finite",
       [](Query& q, SearchOptions&) { q.patches[1].positions[1][1] = -kInfinite; }},
      {"patches[1].velocities[2][2]: -nan is not finite",
       [](Query& q, SearchOptions&) { q.patches[1].velocities[2][2] = -kNan; }},
      {"t_max: nan is not a finite number ≥ 0", [](Query& q, SearchOptions&) { q.t_max = kNan; }},
      {"t_max: -5e-324 is not a finite number ≥ 0",
       [](Query& q, SearchOptions&) { q.t_max = -0x1p-1074; }},
      {"precision: nan is not in (0, 1]", [](Query&, SearchOptions& o) { o.precision = kNan; }},
      {"precision: 0 is not in (0, 1]", [](Query&, SearchOptions& o) { o.precision = 0; }},
      {"precision: 1.0000000000000002 is not in (0, 1]",
       [](Query&, SearchOptions& o) { o.precision = std::nextafter(1.0, 2.0); }},
      {"max_seconds: nan is not a number", [](Query&, SearchOptions& o) { o.max_seconds = kNan; }},
  };
}

std::vector<Spoilt> spoilt_structures() {
  const auto reshape = [](const Shape& shape) {
    return [shape](Query& q, SearchOptions&) {
      const double t_max = q.t_max;
      q = meeting(shape);
      q.t_max = t_max;
    };
  };
  const auto relabel = [](const Shape& shape) {
    return [shape](Query& q, SearchOptions&) { q.patches[0].shape = shape; };
  };
  return {
      {"patches[0].positions: has 2; triangle(1) needs 3",
       [](Query& q, SearchOptions&) { q.patches[0].positions.pop_back(); }},
      {"patches[1].positions: has 103; triangle(1) needs 3",
       [](Query& q, SearchOptions&) { q.patches[1].positions.resize(103); }},
      {"patches[0].velocities: has 0; triangle(1) needs 3",
       [](Query& q, SearchOptions&) { q.patches[0].velocities = {}; }},
      {"patches[0]: tensor(9,1) has a degree outside 1..8", reshape(Shape::tensor(9, 1))},
      {"patches[0]: curve(-1) has a degree outside 1..8", relabel(Shape::curve(-1))},
      {"patches[0]: triangle(1) with a second degree 1, which must be 0",
       relabel({ShapeKind::kTriangle, 1, 1})},
      {"patches[0]: a point with the degrees 3 and 0, which must be 0",
       relabel({ShapeKind::kPoint, 3, 0})},
      {"patches[0]: kind 255 is none of 0 (point) to 4 (hull)",
       relabel({static_cast<ShapeKind>(255), 2147483647, -2147483647})},
      {"patches[0]: 82, 0: a hull has 1..81 points, and no second number",
       relabel(Shape::hull(82))},
      {"patches[0].velocities: has 3; hull(3) needs 1", relabel(Shape::hull(3))},
      {"patches[0].shape: hull stands beside a triangle; both patches are hulls, or none",
       [](Query& q, SearchOptions&) {
         q.patches[0].shape = Shape::hull(3);
         q.patches[0].velocities.resize(1);
       }},
      {"patches[1].radius: 1 is not 0, as of all but hulls",
       [](Query& q, SearchOptions&) { q.patches[1].radius = 1; }},
  };
}

TEST(Refusal, EveryMethodNamesTheFieldAndItsValue) {
  std::vector<Spoilt> all = spoilt_numbers();
  for (Spoilt& spoilt : spoilt_structures()) all.push_back(std::move(spoilt));
  for (const std::string& spec : every_method()) {
    const auto method = *make_method(spec);
    for (const Spoilt& spoilt : all) {
      Query query = meeting(Shape::triangle(1));
      SearchOptions options;
      options.max_pops = 1000;
      ASSERT_NE(method->answer(query, options).verdict, Verdict::kRefused) << spec;
      spoilt.spoil(query, options);
      const Answered answer = method->answer(query, options);
      EXPECT_EQ(name_of(answer.verdict), "refused") << spec << ": " << spoilt.note;
      EXPECT_EQ(answer.note, spoilt.note) << spec;
      EXPECT_FALSE(answer.toi) << spec;
      EXPECT_EQ(judge(known(query), answer), Outcome::kNotAsked) << spec;
    }
  }
}

TEST(Refusal, LeavesAnInvalidQueryUndecidedAndUnproven) {
  std::vector<Spoilt> all = spoilt_structures();
  for (const Spoilt& spoilt : all) {
    Query query = meeting(Shape::triangle(1));
    SearchOptions options;
    spoilt.spoil(query, options);
    const Decision decision = decide(query);
    EXPECT_FALSE(decision.truth.collides) << spoilt.note;
    EXPECT_FALSE(decision.truth.clear_until) << spoilt.note;
    EXPECT_EQ(decision.note, spoilt.note);
    EXPECT_FALSE(proves_clear(query, Rational(1, 4))) << spoilt.note;
  }
}

TEST(Refusal, TracersThrowOnWhatIsNotValid) {
  std::vector<Spoilt> all = spoilt_structures();
  for (Spoilt& spoilt : spoilt_numbers()) {
    if (!spoilt.note.starts_with("max_seconds")) all.push_back(std::move(spoilt));
  }
  const Witness witness{Rational(1, 2), {}};
  for (const std::string& spec : every_method()) {
    const auto method = *make_method(spec);
    EXPECT_FALSE(method->trace(meeting(Shape::triangle(1)), witness, {}).lost) << spec;
    for (const Spoilt& spoilt : all) {
      Query query = meeting(Shape::triangle(1));
      SearchOptions search;
      spoilt.spoil(query, search);
      EXPECT_THROW(method->trace(query, witness, {.precision = search.precision}), InternalError)
          << spec << ": " << spoilt.note;
    }
    const Witness before{Rational(-1, 2), {}}, after{Rational(3, 2), {}};
    EXPECT_THROW(method->trace(meeting(Shape::triangle(1)), before, {}), InternalError) << spec;
    EXPECT_THROW(method->trace(meeting(Shape::triangle(1)), after, {}), InternalError) << spec;
  }
}

}  // namespace
}  // namespace ccdfuzz
