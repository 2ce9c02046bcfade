// What a plug-in claims changes the verdict: each claim beside the same answers without it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "admitted.hpp"
#include "base/verify.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/oracle.hpp"
#include "method/ask.hpp"
#include "method/plugin/feature_claims.hpp"
#include "method/plugin/line_protocol.hpp"

namespace ccdfuzz {
namespace {

const std::string kClaiming = std::string("plugin:") + CCDFUZZ_TEST_CLAIMING_PLUGIN + ":seconds=30";

// Bits of ccdfuzz_description.claims, and kinds of tolerance.
constexpr const char* kConservative = ":claims=7";
constexpr const char* kOpenTMax = ":claims=4";
constexpr const char* kNotAtZero = ":claims=2";

/// Two points. One moves along the x axis at speed 1, from -contact to where the other rests. They
/// are 100 away from the origin, since some tolerances are relative to coordinates.
Case meeting_at(double contact, double t_max) {
  Case made;
  made.query.patches[0] = {Shape::point(), {{-contact, 100, 0}}, {{1, 0, 0}}};
  made.query.patches[1] = {Shape::point(), {{0, 100, 0}}, {{0, 0, 0}}};
  made.query.t_max = t_max;
  made.truth.witness = Witness{exact(contact), {}};
  made.truth.clear_until = exact(contact);
  made.truth.clearance = LinearClearance{exact(contact), false};
  made.truth.collides = contact <= t_max;
  if (contact > t_max) made.truth.proof = "L";
  return made;
}

/// The outcome of a plug-in with these options; "error (name)" for an error.
std::string outcome_of(const std::string& options, const Case& known) {
  auto method = admitted(kClaiming + options);
  if (!method) return method.error().message();
  const Judged judged = ask(**method, checked_or_unknown(known), {});
  const std::string name(name_of(judged.outcome));
  return judged.error.empty() ? name : name + " (" + judged.error + "): " + judged.answer.note;
}

std::string hit(double toi) {
  return fmt::format(":verdict=1:toi={:.17g}:uv=0", toi);
}
const std::string kMiss = ":verdict=2";

TEST(PluginClaims, EndsAreAskedOfWhomTakesThem) {
  Case known = meeting_at(0.5, 1);
  for (MovingPatch<double>& patch : known.query.patches) {
    patch.ends = {patch.positions[0] + patch.velocities[0]};
    patch.velocities.clear();
  }
  ASSERT_TRUE(is_valid(known.query));
  // Its answer to ends is a hit at 0. Without the claim it is asked with velocities.
  EXPECT_EQ(outcome_of(kMiss, known), "missed");
  EXPECT_EQ(outcome_of(kMiss + ":claims=14", known), "correct");
  // One way is no double, so that there are no velocities to ask with.
  known.query.patches[0].ends[0][2] = 1;
  known.query.patches[0].positions[0][2] = -0x1p-60;
  known.truth = {};
  EXPECT_EQ(outcome_of(kMiss, known), "not_asked");
  EXPECT_EQ(outcome_of(kMiss + ":claims=14", known), "unknown");
}

TEST(PluginClaims, OnlyWhatItPromisesToAnswerIsAsked) {
  // A y coordinate is 100.
  EXPECT_EQ(outcome_of(kMiss + ":within=6", meeting_at(0.5, 1)), "not_asked");
  EXPECT_EQ(outcome_of(kMiss + ":within=7", meeting_at(0.5, 1)), "missed");
  EXPECT_EQ(outcome_of(kMiss + ":claims=262", meeting_at(0.1, 1)), "not_asked")
      << "0.1 is no float";
  EXPECT_EQ(outcome_of(kMiss + ":claims=262", meeting_at(0.5, 1)), "missed");
  EXPECT_EQ(outcome_of(kMiss + ":claims=518", meeting_at(1, 1)), "not_asked") << "not ordinary";
  EXPECT_EQ(outcome_of(kMiss + ":claims=518", meeting_at(0.5, 1)), "missed");
  const std::string promising = kClaiming + kMiss + ":claims=774:within=7:promise=1";
  ASSERT_TRUE(admitted(promising));
  EXPECT_EQ(method_info(promising)->description,
            "claiming 1; floats, within 2^±7, ordinary queries alone, promises: all contacts: "
            "https://example.org/promise");
}

TEST(PluginClaims, BodiesAreAskedOfWhomTakesThem) {
  Case known;
  known.query.patches[0] = {Shape::hull(2), {{0, 0, 0}, {0, 2, 0}}, {{1, 0, 0}}};
  known.query.patches[1] = {Shape::hull(1), {{3, 1, 0}}, {{0, 0, 0}}};
  known.query.patches[1].radius = 1;
  known.query.t_max = 4;
  known.truth.collides = true;
  known.truth.witness = Witness{2, {}, {{{Rational(1, 2), Rational(1, 2)}, {1}}}};
  known.truth.clear_until = 2;
  known.truth.clearance = BodyClearance{2, {1, 0, 0}, false};
  EXPECT_EQ(outcome_of(kMiss, known), "not_asked");
  EXPECT_EQ(outcome_of(kMiss + ":claims=70", known), "missed");
  EXPECT_EQ(outcome_of(":verdict=1:toi=2.5:claims=70", known), "late");
  // They pass 1/8 into each other by then, which no tolerance of who is conservative excuses.
  const std::string shallow = ":verdict=1:toi=2.125:kind=2:tolerance=0.125:claims=";
  EXPECT_EQ(outcome_of(shallow + "70", known), "correct");
  EXPECT_EQ(outcome_of(shallow + "71", known), "late");
  EXPECT_EQ(outcome_of(":verdict=1:toi=2.125:separation=0.125:claims=71", known), "late");
  EXPECT_EQ(outcome_of(kMiss + ":claims=1094", known), "missed") << "in the plane z = 0";
  Case moved = known;
  for (MovingPatch<double>& body : moved.query.patches) {
    for (Vec3<double>& p : body.positions) p[2] = 1;
  }
  EXPECT_EQ(outcome_of(kMiss + ":claims=1094", moved), "not_asked");
  EXPECT_EQ(outcome_of(kMiss + ":claims=70", moved), "missed");
  known.query.t_max = 1;
  known.truth.collides = false;
  known.truth.proof = "K";
  EXPECT_EQ(outcome_of(kMiss + ":claims=70", known), "correct");
  EXPECT_EQ(outcome_of(":verdict=1:toi=1:claims=70", known), "false_positive");
  // They are 1 apart then, as the direction shows, wherever it says that they are nearest.
  const std::string early = ":verdict=1:toi=1:claims=70:kind=2:tolerance=";
  EXPECT_EQ(outcome_of(early + "0.99", known), "false_positive");
  EXPECT_EQ(outcome_of(early + "1", known), "unknown");
  // Only of kinds that it has shapes for: the second body is round.
  EXPECT_EQ(outcome_of(kMiss + ":claims=70:points=2", known), "not_asked");
  known.query.patches[1].radius = 0;
  known.truth = {};
  EXPECT_EQ(outcome_of(kMiss + ":claims=70:points=2", known), "unknown");
  EXPECT_EQ(outcome_of(kMiss + ":claims=70:points=1", known), "not_asked");
}

TEST(PluginClaims, MeshesAreAskedOfWhomTakesThem) {
  Case known;
  auto& [mesh, ball] = known.query.patches;
  mesh = {Shape::hull(4), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 0, 0}}};
  mesh.faces = {{0, 1, 2}, {2, 1, 3}};
  ball = {Shape::hull(1), {{0, 0, 8}}, {{0, 0, -1}}};
  const std::string bodies_alone = kMiss + ":claims=70";
  EXPECT_EQ(outcome_of(bodies_alone, known), "not_asked");
  EXPECT_EQ(outcome_of(kMiss + ":claims=16454", known), "undecided") << "of two sides";
  EXPECT_EQ(outcome_of(kMiss + ":claims=32838", known), "not_asked") << "of fronts alone";
  mesh.one_sided = true;
  EXPECT_EQ(outcome_of(kMiss + ":claims=16454", known), "not_asked");
  EXPECT_EQ(outcome_of(kMiss + ":claims=32838", known), "unknown") << "a hit";
  // Its points are not counted as those of a hull.
  EXPECT_EQ(outcome_of(kMiss + ":claims=32838:points=1", known), "unknown");
}

TEST(PluginClaims, WeightsAreAskedOfWhomTakesThem) {
  Case known = meeting_at(0.5, 1);
  MovingPatch<double>& edge = known.query.patches[0];
  edge.shape = Shape::curve(1);
  edge.positions.push_back(edge.positions[0]);
  edge.velocities.push_back(edge.velocities[0]);
  // Its answer to weights is a hit at 0. Equal ones are none.
  edge.weights = {1, 1};
  EXPECT_EQ(outcome_of(kMiss, known), "missed");
  edge.weights = {1, 2};
  EXPECT_EQ(outcome_of(kMiss, known), "not_asked");
  EXPECT_EQ(outcome_of(kMiss + ":claims=38", known), "correct");
}

TEST(PluginClaims, TrimsAreAskedOfWhomTakesThem) {
  Case known = meeting_at(0.5, 1);
  MovingPatch<double>& face = known.query.patches[0];
  face.shape = Shape::triangle(1);
  face.positions.resize(3, face.positions[0]);
  face.velocities.resize(3, face.velocities[0]);
  EXPECT_EQ(outcome_of(kMiss, known), "missed");
  // Its answer to these loops is a hit at 0.
  face.trim = {{{0, 0}, {1, 0}, {0, 1}},
               {{0.125, 0.125}, {0.25, 0.125}, {0.25, 0.25}, {0.125, 0.25}}};
  EXPECT_EQ(outcome_of(kMiss, known), "not_asked");
  EXPECT_EQ(outcome_of(kMiss + ":claims=134", known), "correct");
}

TEST(PluginClaims, AnOpenEndBindsNot) {
  EXPECT_EQ(outcome_of(kMiss, meeting_at(1, 1)), "missed");
  EXPECT_EQ(outcome_of(kMiss + kOpenTMax, meeting_at(1, 1)), "correct");
  EXPECT_EQ(outcome_of(kMiss, meeting_at(0, 1)), "missed");
  EXPECT_EQ(outcome_of(kMiss + kNotAtZero, meeting_at(0, 1)), "unknown");
}

TEST(PluginClaims, AToleranceInTimeExcusesWhatIsLateUnlessConservative) {
  const Case known = meeting_at(0.5, 2);
  EXPECT_EQ(outcome_of(hit(0.75) + ":tolerance=0.25", known), "correct");
  EXPECT_EQ(outcome_of(hit(0.75) + ":tolerance=0.24", known), "late");
  EXPECT_EQ(outcome_of(hit(0.75) + ":tolerance=0.25" + kConservative, known), "late");
  // Relative to t_max = 2.
  EXPECT_EQ(outcome_of(hit(0.75) + ":tolerance=0.125:kind=1", known), "correct");
  EXPECT_EQ(outcome_of(hit(0.75) + ":tolerance=0.12:kind=1", known), "late");
  // One in space says nothing of time.
  EXPECT_EQ(outcome_of(hit(0.75) + ":tolerance=0.25:kind=2", known), "late");
}

TEST(PluginClaims, AToleranceExcusesAHitBeforeAContactThatComesTooLate) {
  const Case known = meeting_at(2.25, 2);
  EXPECT_EQ(outcome_of(hit(2) + ":tolerance=0.25", known), "correct");
  EXPECT_EQ(outcome_of(hit(2) + ":tolerance=0.25" + kConservative, known), "correct");
  EXPECT_EQ(outcome_of(hit(2) + ":tolerance=0.24", known), "false_positive");
  EXPECT_EQ(outcome_of(hit(2) + ":tolerance=0.125:kind=1", known), "correct");
  EXPECT_EQ(outcome_of(hit(2) + ":tolerance=0.12:kind=1", known), "false_positive");
  // In space.
  EXPECT_EQ(outcome_of(hit(2) + ":tolerance=0.25:kind=2", known), "correct");
  EXPECT_EQ(outcome_of(hit(2) + ":tolerance=0.24:kind=2", known), "false_positive");
  EXPECT_EQ(outcome_of(hit(2) + ":tolerance=0.25:kind=2:uv=nan", known), "correct");
  // Who does not say where cannot be held to it.
  EXPECT_EQ(outcome_of(":verdict=1:toi=2:tolerance=0.25:kind=2", known), "unknown");
  // Relative to the largest coordinate, 100.
  EXPECT_EQ(outcome_of(hit(2) + ":tolerance=0.0025:kind=3", known), "correct");
  EXPECT_EQ(outcome_of(hit(2) + ":tolerance=0.0024:kind=3", known), "false_positive");
}

TEST(PluginClaims, AnAchievedToleranceStandsInThePlaceOfTheClaimedOneUnlessItIsLooser) {
  const Case known = meeting_at(0.5, 2);
  EXPECT_EQ(outcome_of(hit(0.75) + ":tolerance=0.25:achieved=0.1", known), "late");
  EXPECT_THAT(outcome_of(hit(0.75) + ":tolerance=0.25:achieved=-1", known),
              testing::StartsWith("error (garbage)"));
  // The answer is right by the claim, and yet: what it says of itself is not what it claimed.
  EXPECT_THAT(outcome_of(hit(0.75) + ":tolerance=0.25:achieved=0.26", known),
              testing::StartsWith("error (broken claim): claims a tolerance of 0.25 (time)"));
}

TEST(PluginClaims, AMinimumSeparationExcusesAHitWithinItAndBindsWhoIsConservative) {
  // Not nearer than 1/4 before t_max.
  const Case far = meeting_at(2.25, 2);
  EXPECT_EQ(outcome_of(hit(2) + ":separation=0.25", far), "correct");
  EXPECT_EQ(outcome_of(hit(2) + ":separation=0.24", far), "false_positive");
  EXPECT_EQ(outcome_of(hit(2) + ":separation=0.125:tolerance=0.125:kind=2", far), "correct");
  EXPECT_EQ(outcome_of(kMiss + ":separation=0.25" + kConservative, far), "correct");
  EXPECT_EQ(outcome_of(kMiss + ":separation=0.26" + kConservative, far), "missed");
  EXPECT_EQ(outcome_of(kMiss + ":separation=0.26", far), "correct");
}

TEST(PluginClaims, AMinimumSeparationBindsWhereNothingTouches) {
  // Points that pass each other at 1/4. The claim says so, and the plug-in is not told.
  Case near = meeting_at(1, 2);
  for (Vec3<double>& p : near.query.patches[1].positions) p[2] = 0.25;
  near.query.separation = 0.25;
  near.truth = decide(near.query).truth;
  const std::string claim = std::string(kConservative) + ":separation=0.26";
  EXPECT_EQ(outcome_of(kMiss + claim, near), "missed");
  EXPECT_EQ(outcome_of(hit(1) + claim, near), "correct");
  EXPECT_EQ(outcome_of(hit(1.5) + claim, near), "late");
  for (const char* other :
       {":claims=7:separation=0.25", ":claims=3:separation=0.26", ":separation=0.26"}) {
    EXPECT_EQ(outcome_of(kMiss + other, near), "not_asked") << other;
  }
  near.query.t_max = 0.75;  // they are sqrt(2)/4 apart then, more than what is claimed in all
  near.truth = decide(near.query).truth;
  EXPECT_EQ(outcome_of(hit(0.75) + claim + ":tolerance=0.09:kind=2", near), "false_positive");
  EXPECT_EQ(outcome_of(hit(0.75) + claim + ":tolerance=0.1:kind=2", near), "correct");
}

TEST(PluginClaims, ANanPolicyIsAskedForAndHeldTo) {
  const Case known = meeting_at(0.5, 2);
  const std::string right = hit(0.5);
  // By policy the one verdict that keeps it: error, inconclusive, hit, refused.
  for (const auto& [policy, keeps] :
       {std::pair{1, 4}, std::pair{2, 3}, std::pair{3, 1}, std::pair{4, 5}}) {
    for (int verdict = 1; verdict <= 5; ++verdict) {
      const std::string options = right + fmt::format(":nan={}:poisoned={}", policy, verdict);
      const std::string outcome = outcome_of(options, known);
      if (verdict == keeps) {
        EXPECT_EQ(outcome, "correct") << options;
      } else {
        EXPECT_THAT(outcome, testing::StartsWith("error (nan policy): claims \"")) << options;
      }
    }
  }
  // As if nothing were wrong; a hit, but not at once.
  for (const char* policy : {":nan=1", ":nan=2", ":nan=3"}) {
    EXPECT_THAT(
        outcome_of(right + policy, known),
        testing::AllOf(testing::StartsWith("error (nan policy)"),
                       testing::HasSubstr("asked with patches["), testing::EndsWith("hit at 0.5")))
        << policy;
  }
  // Who claims nothing, or is asked once only, is not asked.
  EXPECT_EQ(outcome_of(right + ":nan=0:poisoned=9", known), "correct");
  EXPECT_EQ(outcome_of(right + ":nan=1:repeat=no:poisoned=9", known), "correct");
  // An error of the process is reported by its own name.
  EXPECT_THAT(outcome_of(right + ":nan=1:poisoned=9", known),
              testing::StartsWith("error (crash SIGSEGV): asked with patches["));
  // A toi that is NaN is no answer, whatever it claims to say to NaN.
  EXPECT_THAT(outcome_of(":verdict=1:toi=nan:nan=3:poisoned=1", known),
              testing::StartsWith("error (toi NaN)"));
  // A wrong answer to the query itself weighs more than a broken claim.
  EXPECT_EQ(outcome_of(kMiss + ":nan=1", known), "missed");
  EXPECT_EQ(outcome_of(hit(1) + ":nan=1", known), "late");
}

TEST(PluginClaims, DoNotApplyToRefusedQueries) {
  for (const Case& known : {meeting_at(0.5, 2), meeting_at(0.5, 0.25)}) {
    EXPECT_EQ(outcome_of(":verdict=5", known), "not_asked");
    EXPECT_EQ(outcome_of(std::string(":verdict=5:nan=1") + kConservative, known), "not_asked");
    EXPECT_EQ(outcome_of(":verdict=5:repeat=no", known), "not_asked");
    EXPECT_EQ(ask(**admitted(kClaiming + ":verdict=5"), checked_or_unknown(known), {}).answer.note,
              "as the options say");
  }
}

TEST(PluginClaims, AreTheLargestDoubleWhenTheyOverflow) {
  // Two points at a distance of 100 that run off the end of double.
  Case known = meeting_at(2.25, 2);
  known.truth = {};
  known.truth.collides = false;
  known.truth.proof = "L";
  known.truth.clearance = LinearClearance{exact(known.query.t_max), true};
  known.query.patches[0] = {Shape::point(), {{0, 100, 0}}, {{1.7e308, 0, 0}}};
  known.query.patches[1] = {Shape::point(), {{0, 0, 0}}, {{1.7e308, 0, 0}}};
  EXPECT_EQ(outcome_of(hit(2) + ":kind=3", known), "false_positive");
  EXPECT_EQ(outcome_of(hit(2) + ":kind=3:tolerance=0.1:achieved=0", known), "false_positive");
  EXPECT_EQ(outcome_of(hit(2) + ":kind=3:tolerance=0.1", known), "correct");
}

struct NotOnItsTerms : Method {
  Answered answer(const Query& /*query*/, const SearchOptions& /*options*/) override {
    Answered given{Answer::hit(0.5)};
    given.terms.time_tolerance = std::numeric_limits<double>::infinity();
    return given;
  }
};

TEST(Ask, DoesNotBlameAMethodForWhatIsBrokenInTheJudge) {
  NotOnItsTerms method;
  EXPECT_THROW(ask(method, checked_or_unknown(meeting_at(0.5, 2)), {}), InternalError);
}

TEST(PluginClaims, ANaNInARadiusOrATurnReachesThePlugIn) {
  Case known;
  known.query.patches[0] = {Shape::hull(1), {{0, 0, 8}}, {{0, 0, -1}}};
  known.query.patches[1] = {Shape::hull(2), {{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}}};
  known.query.patches[0].radius = 1;
  known.query.patches[0].turn = BodyTurn{{}, {}, {0, 0, 8}, {0.5, 0, 1}};
  known.query.patches[1].turn = BodyTurn{{1, 0}, {1, 0.5}, {0, 0, 0}};
  for (int i = 1; i <= 60; ++i) {  // where the NaN is depends on the query
    known.query.t_max = 1.0 / i;
    ASSERT_TRUE(is_valid(known.query));
    // Of bodies that turn by angles and spin; a NaN is an error, and this one answers so.
    EXPECT_EQ(outcome_of(kMiss + ":claims=12359:nan=1:poisoned=4", known), "unknown");
  }
}

TEST(PluginClaims, AreShownToWhoeverAsksWhatItIs) {
  const std::string spec = kClaiming + ":claims=1:tolerance=0.25:kind=2:separation=0.5:nan=3";
  ASSERT_TRUE(admit_plugin(kClaiming));
  ASSERT_TRUE(admit_plugin(spec));
  EXPECT_EQ(method_info(kClaiming)->description, "claiming 1");
  const auto info = method_info(spec);
  EXPECT_TRUE(info->claims_no_false_negative);
  EXPECT_TRUE(words_of(info->features).empty());
  ASSERT_TRUE(admit_plugin(kClaiming + ":claims=41031"));
  EXPECT_EQ(words_of(method_info(kClaiming + ":claims=41031")->features),
            (std::vector<std::string>{"bodies", "spins", "one-sided"}));
  EXPECT_EQ(info->description,
            "claiming 1; open t_max, no contact at 0, tolerance 0.25 (space), minimum separation "
            "0.5, NaN: hit");
}

TEST(PluginClaims, ByNumbersThatMeanNothingAreNamed) {
  EXPECT_THAT(admitted(kClaiming + ":kind=9").error().message(),
              testing::EndsWith("describes a tolerance_kind 9 that there is not"));
  EXPECT_THAT(admitted(kClaiming + ":nan=7").error().message(),
              testing::EndsWith("describes a nan_policy 7 that there is not"));
  EXPECT_THAT(admitted(kClaiming + ":within=1075").error().message(),
              testing::EndsWith("within: 1075 is outside 0..1074"));
}

}  // namespace
}  // namespace ccdfuzz
