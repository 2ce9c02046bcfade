#include "finds/failure.hpp"

#include <gmock/gmock.h>

#include <set>

#include "finds/finds.hpp"

namespace ccdfuzz {
namespace {

/// An edge that falls by 1 onto a point at (x, 0, 0), at t = 1/2, in [0, 1].
Case falling_edge() {
  Case c;
  c.query.patches[0] = {Shape::curve(1), {{-1, 1, 0}, {1, 1, 0}}, {{0, -2, 0}, {0, -2, 0}}};
  c.query.patches[1] = {Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
  c.query.t_max = 1;
  c.truth.collides = true;
  c.truth.witness = Witness{Rational(1, 2), {}};
  c.truth.witness->uv[0] = {Rational(1, 2), Rational(0)};
  c.origin.contact = "VE";
  c.expect["tdibm"] = {Outcome::kMissed, "left root"};
  return c;
}

TEST(Setting, TellsTrivialQueriesFromOrdinaryOnes) {
  Case c = falling_edge();
  EXPECT_EQ(setting_of(c), Setting::kOrdinary);
  c.query.t_max = 0.5;
  EXPECT_EQ(setting_of(c), Setting::kAtAnEnd);
  c.query.t_max = 0.5 + 0x1p-12;
  EXPECT_EQ(setting_of(c), Setting::kAtAnEnd);
  c.query.t_max = 0.5 + 0x1p-9;
  EXPECT_EQ(setting_of(c), Setting::kOrdinary);
  c.truth = {};
  c.truth.collides = false;
  EXPECT_EQ(setting_of(c), Setting::kOrdinary) << "nothing touches";
  c.query.t_max = 0;
  EXPECT_EQ(setting_of(c), Setting::kAtAnEnd) << "a step of no length";
  c = falling_edge();
  c.query.patches[0].positions = {{-1, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(setting_of(c), Setting::kTouching);
  c = falling_edge();
  c.query.patches[1].velocities[0] = c.query.patches[0].velocities[0];
  EXPECT_EQ(setting_of(c), Setting::kDegenerate) << "nothing moves against the rest";
  c = falling_edge();
  c.query.patches[0].positions[1] = c.query.patches[0].positions[0];
  EXPECT_EQ(setting_of(c), Setting::kDegenerate) << "no extent";
  c.query.patches[0].velocities[1] = {1, -2, 0};
  EXPECT_EQ(setting_of(c), Setting::kDegenerate) << "no extent at the start";
  c = falling_edge();
  c.query.patches[0].positions[1][2] = 0x1p40;
  EXPECT_EQ(setting_of(c), Setting::kOrdinary);
  for (const double x : {0x1.8p40, 0x1p-41}) {
    c.query.patches[0].positions[1][2] = x;
    EXPECT_EQ(setting_of(c), Setting::kExtreme) << x;
  }
}

TEST(Setting, TellsTrianglesWithoutAreaAtTheStartOrAtTheContact) {
  Case c = falling_edge();
  MovingPatch<double>& triangle = c.query.patches[0];
  const Points<double> fall(3, {0, -2, 0});
  triangle = {Shape::triangle(1), {{-1, 1, -1}, {1, 1, -1}, {0, 1, 1}}, fall};
  EXPECT_EQ(setting_of(c), Setting::kOrdinary);
  triangle.positions[2] = {0, 1, -1 + 0x1p-8};
  EXPECT_EQ(setting_of(c), Setting::kOrdinary) << "thin";
  triangle.positions[2] = {0, 1, -1 + 0x1p-10};
  EXPECT_EQ(setting_of(c), Setting::kDegenerate) << "as good as a line";
  triangle.positions[2] = {0, 1, 0};
  triangle.velocities[2] = {0, -2, -2};
  EXPECT_EQ(setting_of(c), Setting::kDegenerate) << "a line at the contact";
}

TEST(Setting, TellsPointsThatMoveInThePlaneOfTheTriangle) {
  Case c = falling_edge();
  c.query.patches[0] = {Shape::point(), {{0, -1, 0}}, {{0, 2, 0}}};
  c.query.patches[1] = {
      Shape::triangle(1), {{-1, 0, 0}, {1, 0, 0}, {0, 2, 0}}, Points<double>(3, {0, 0, 0})};
  c.truth.witness->uv = {{{Rational(0), Rational(0)}, {Rational(0), Rational(1, 2)}}};
  EXPECT_EQ(setting_of(c), Setting::kSliding);
  c.query.patches[0].velocities[0][2] = 0x1p-8;
  c.query.patches[0].positions[0][2] = -0x1p-9;
  EXPECT_EQ(setting_of(c), Setting::kOrdinary) << "slightly across";
  c.query.patches[0].velocities[0][2] = c.query.patches[0].positions[0][2] = 0;
  c.truth.witness.reset();
  EXPECT_EQ(setting_of(c), Setting::kSliding) << "all in one plane, the time of contact unknown";
}

TEST(Failure, IsWhatACaseExpectsInItsSetting) {
  Case c = falling_edge();
  c.expect["tdibm-c"] = Outcome::kCorrect;
  c.expect["trad"] = {Outcome::kError, "crash SIGSEGV"};
  const std::vector<Failure> failures = failures_of(c);
  ASSERT_EQ(failures.size(), 2U);
  EXPECT_EQ(to_text(failures[0]), "missed by tdibm (VE, left root)");
  EXPECT_EQ(file_stem(failures[0]), "tdibm-missed-VE-left-root");
  EXPECT_EQ(to_text(failures[1]), "error by trad (crash SIGSEGV)");
  EXPECT_EQ(file_stem(failures[1]), "trad-error-crash-SIGSEGV");
  c.query.t_max = 0.5;
  EXPECT_EQ(to_text(failures_of(c)[0]), "missed by tdibm (VE, left root, at an end)");
  EXPECT_EQ(failures_of(c)[1], failures[1]) << "a crash is a crash in whatever setting";
}

TEST(FileStem, TellsFailuresApartInCharactersThatEveryFolderTakes) {
  std::set<std::string> stems;
  size_t count = 0;
  for (const std::string who :
       {"tdibm", "tdibm-h:1e-16", "tdibm-h_1e-16", "plugin:./a.so", "plugin:./a-so", ".hidden",
        "plugin-exec:/some/where/very/far/away/from/here/in/the/depths/of/a/disk/solver one",
        "plugin-exec:/some/where/very/far/away/from/here/in/the/depths/of/the/disk/solver one"}) {
    for (const Outcome outcome : {Outcome::kMissed, Outcome::kError}) {
      for (const Setting setting : kAllSettings) {
        const std::string stem = file_stem({who, outcome, "VE", "left root", setting});
        ++count;
        EXPECT_TRUE(stems.insert(stem).second) << stem;
        EXPECT_LE(stem.size(), 120U) << stem;
        EXPECT_THAT(stem, testing::MatchesRegex("[A-Za-z0-9-][A-Za-z0-9._-]*"));
      }
    }
  }
  EXPECT_EQ(stems.size(), count);
}

TEST(Failure, OfBodiesHasTheirKindAsItsCause) {
  Asker asker{SearchOptions()};
  Case value;
  for (MovingPatch<double>& body : value.query.patches) {
    body = {Shape::hull(3), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}}};
  }
  MovingPatch<double>& first = value.query.patches[0];
  const auto cause = [&](Outcome outcome) {
    Judged judged;
    judged.outcome = outcome;
    return asker.expected("tdibm", value, judged).cause;
  };
  EXPECT_EQ(cause(Outcome::kMissed), "");
  first.turn = BodyTurn{{1, 0}, {1, 1}, {0, 0, 0}};
  EXPECT_EQ(cause(Outcome::kMissed), "turn");
  first.turn = BodyTurn{{}, {}, {0, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(cause(Outcome::kLate), "spin");
  EXPECT_EQ(cause(Outcome::kCorrect), "");
  first.turn.reset();
  first.faces = {{0, 1, 2}};
  EXPECT_EQ(cause(Outcome::kFalsePositive), "mesh");
  first.one_sided = true;
  EXPECT_EQ(cause(Outcome::kMissed), "one-sided mesh");
}

TEST(Change, IsARegressionIffItIsWorse) {
  const Expected correct = Outcome::kCorrect, undecided = Outcome::kUndecided,
                 missed = {Outcome::kMissed, "left root"};
  EXPECT_EQ(change_of(correct, correct), Change::kNone);
  EXPECT_EQ(change_of(correct, missed), Change::kRegression);
  EXPECT_EQ(change_of(correct, undecided), Change::kRegression);
  EXPECT_EQ(change_of(undecided, missed), Change::kRegression);
  EXPECT_EQ(change_of(missed, correct), Change::kImprovement);
  EXPECT_EQ(change_of(missed, undecided), Change::kImprovement);
  EXPECT_EQ(change_of(missed, Outcome::kLate), Change::kOther);
  EXPECT_EQ(change_of(undecided, Outcome::kUnknown), Change::kOther);
  // Causes are told apart where the entry says one.
  EXPECT_EQ(change_of({Outcome::kMissed, "left root"}, {Outcome::kMissed, "hull"}), Change::kOther);
  EXPECT_EQ(change_of({Outcome::kError, "hang"}, {Outcome::kError, "crash SIGSEGV"}),
            Change::kOther);
  EXPECT_EQ(change_of(Outcome::kMissed, {Outcome::kMissed, "hull"}), Change::kNone);
}

TEST(Find, SaysNoVersionOrDepthOfAnotherMethod) {
  Case find;
  find.origin.more = {{"version", "\"9.9\""}, {"depth", "1"}, {"depth_tolerance", "1"}};
  say_version(find, "tdibm");
  EXPECT_TRUE(find.origin.more.empty());
}

}  // namespace
}  // namespace ccdfuzz
