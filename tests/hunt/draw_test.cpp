#include "hunt/draw.hpp"

#include <gtest/gtest.h>

#include <set>

#include "case/judge.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/oracle.hpp"
#include "eval/horizons.hpp"
#include "method/plugin/feature_claims.hpp"
#include "method/taken_query.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

TEST(Draw, DependsOnItsArgumentsAlone) {
  for (const ContactClass contact : kContactClasses) {
    const std::vector<CheckedCase> a = Draws(3).at(contact, 8), b = Draws(3).at(contact, 8);
    EXPECT_EQ(a, b);
    EXPECT_NE(a, Draws(4).at(contact, 8)) << "another seed";
  }
}

TEST(Draw, TruthsHoldAndPositiveCasesAreAskedAtEveryHorizon) {
  for (const ContactClass contact : kContactClasses) {
    for (std::uint64_t index = 0; index < 40; index += 3 * kOneIn) {
      const std::vector<CheckedCase> drawn = Draws(1).at(contact, index);
      ASSERT_FALSE(drawn.empty());
      for (const CheckedCase& asked : drawn) {
        const Result<void> checked = check_truth(asked.value());
        EXPECT_TRUE(checked) << name_of(contact) << " " << index << ": "
                             << checked.error().message();
        ASSERT_TRUE(asked.value().truth.collides.has_value());
      }
      const bool positive = *drawn[0].value().truth.collides;
      EXPECT_EQ(drawn.size(), positive ? kHorizonFactors.size() : 1U);
      for (size_t i = 1; i + 1 < drawn.size(); ++i) {  // the last may be near_an_end
        EXPECT_LT(drawn[i - 1].query().t_max, drawn[i].query().t_max);
      }
    }
  }
}

TEST(Draw, GoesRoundAllConstructionsAndFamiliesWithAllTheKindsThatTheyHave) {
  std::set<std::string> seen, wanted;
  for (std::uint64_t index = 0; index < 80; ++index) {
    const Origin origin = Draws(1).at(ContactClass::kVV, index)[0].value().origin;
    seen.insert(origin.generator + " " + origin.kind);
  }
  for (const CaseKind kind : kCaseKinds) {
    const auto want = [&](std::string_view name) {
      wanted.insert(std::string(name) + " " + std::string(name_of(kind)));
    };
    for (const Construction construction : kConstructions) want(name_of(construction));
    for (const Family family : kFamilies) {
      if (family != Family::kRegular && is_made(family, ContactClass::kVV, kind)) {
        want(name_of(family));
      }
    }
  }
  EXPECT_EQ(seen, wanted);
  EXPECT_TRUE(seen.contains("area RP"));
  EXPECT_FALSE(seen.contains("ruled RP")) << "there is none of VV";
}

/// The families of weights, loops, ends and separations among the draws for such a method.
std::set<std::string> not_plain_draws(const Features& taken) {
  const Draws draws(1, {}, taken);
  std::set<std::string_view> not_plain;
  for (const Family family : kNotPlainFamilies) not_plain.insert(name_of(family));
  std::set<std::string> seen;
  for (std::uint64_t n = 0; n < 30; ++n) {
    const std::vector<CheckedCase> drawn = draws.at(ContactClass::kFF, n);
    EXPECT_FALSE(drawn.empty()) << n;
    for (const CheckedCase& asked : drawn) {
      EXPECT_NE(TakenQuery(asked.query(), taken).query(), nullptr) << n;
      const std::string& family = asked.value().origin.generator;
      if (not_plain.contains(family)) seen.insert(family);
    }
  }
  return seen;
}

TEST(Draw, OffersAMethodTheKindsThatItTakesAndNoOthers) {
  const auto seen = not_plain_draws;
  using Families = std::set<std::string>;
  EXPECT_EQ(seen({}), Families());
  EXPECT_EQ(seen({.ends = true}), Families{"ends"});
  EXPECT_EQ(seen({.separation = true}), Families{"separated"}) << "round patches have weights";
  EXPECT_EQ(seen({.weights = true}), (Families{"weighted", "round"}));
  EXPECT_EQ(seen({.trims = true}), Families{"trimmed"});
  EXPECT_EQ(seen(kAllFeatures),
            (Families{"weighted", "round", "apart", "trimmed", "ends", "separated"}));
}

TEST(Draw, OffersLinearCodesEndsAndSeparations) {
  HuntGround ground;
  ground.linear = true;
  const Features taken{.ends = true, .separation = true};
  const Draws draws(1, ground, taken);
  std::set<std::string> seen;
  for (std::uint64_t n = 0; n < 6; ++n) {
    for (const CheckedCase& asked : draws.at(ContactClass::kVF, n)) {
      EXPECT_TRUE(ground.has(asked.value()));
      seen.insert(asked.value().origin.generator);
    }
  }
  EXPECT_EQ(seen, (std::set<std::string>{"linear", "ends", "separated"}));
}

TEST(Draw, OffersFloatCodesEndsAndWhatIsNearerThanTheyKeep) {
  HuntGround ground;
  ground.pairs = linear_pairs();
  ground.binary32 = ground.ordinary = true;
  ground.scale = 7;
  const Draws draws(1, ground, {.ends = true, .kept_separation = 0.001});
  int all = 0, of_ends = 0, near = 0;
  for (std::uint64_t n = 0; n < 60; ++n) {
    for (const CheckedCase& asked : draws.at(ContactClass::kVF, n)) {
      ++all;
      of_ends += has_ends(asked.query()) ? 1 : 0;
      Query touching = asked.query();
      touching.separation = 0;
      near += asked.collides() == true && decide(touching).truth.collides == false ? 1 : 0;
    }
  }
  EXPECT_GT(2 * of_ends, all);
  EXPECT_GE(near, 2);
}

TEST(Draw, OffersBodiesThatTurnToWhoTakesThem) {
  for (bool Features::*turn : {&Features::turns, &Features::angles, &Features::spins}) {
    const bool plane = turn == &Features::angles;
    HuntGround ground;
    ground.bodies = true;
    ground.plane = plane;
    Features taken{.bodies = true};
    taken.*turn = true;
    const auto turning_of = [&](const Features& features) {
      const Draws draws(1, ground, features);
      int turning = 0;
      for (std::uint64_t n = 0; n < 8; ++n) {
        for (const CheckedCase& asked : draws.at(draws.classes().front(), n)) {
          turning += has_turns(asked.query()) ? 1 : 0;
          EXPECT_EQ(has_spins(asked.query()), has_turns(asked.query()) && features.spins);
        }
      }
      return turning;
    };
    EXPECT_GE(turning_of(taken), 1) << plane;
    EXPECT_EQ(turning_of({.bodies = true}), 0) << plane;
  }
}

TEST(Draw, OffersMeshesToWhoTakesThem) {
  HuntGround ground;
  ground.bodies = true;
  const auto meshes_of = [&](const Features& features) {
    const Draws draws(1, ground, features);
    std::set<bool> sides;
    for (std::uint64_t n = 0; n < 8; ++n) {
      for (const CheckedCase& asked : draws.at(draws.classes().front(), n)) {
        for (const MovingPatch<double>& body : asked.query().patches) {
          if (!body.faces.empty()) sides.insert(body.one_sided);
        }
      }
    }
    return sides;
  };
  EXPECT_EQ(meshes_of({.bodies = true}), (std::set<bool>{}));
  EXPECT_EQ(meshes_of({.bodies = true, .one_sided = true}), (std::set<bool>{true}));
  EXPECT_EQ(meshes_of({.bodies = true, .meshes = true, .one_sided = true}),
            (std::set<bool>{false, true}));
}

TEST(Draw, CyclesThroughTheClassesAndFamiliesOfItsShapes) {
  struct Expected {
    std::array<Shape, 2> shapes;
    std::vector<ContactClass> classes;
  };
  const std::vector<ContactClass> all(kContactClasses.begin(), kContactClasses.end());
  using enum ContactClass;
  for (const auto& [shapes, classes] :
       {Expected{{Shape::triangle(8), Shape::triangle(8)}, all},
        Expected{{Shape::tensor(1, 5), Shape::triangle(3)}, all},
        Expected{{Shape::curve(4), Shape::curve(1)}, {kEE, kVE, kVV}},
        Expected{{Shape::point(), Shape::tensor(3, 3)}, {kVF, kVE, kVV}},
        Expected{{Shape::point(), Shape::point()}, {kVV}}}) {
    HuntGround ground;
    ground.shapes = shapes;
    const Draws draws(1, ground);
    EXPECT_EQ(draws.classes(), classes) << to_text(shapes[0]) << " " << to_text(shapes[1]);
    std::set<bool> orders;
    for (const ContactClass contact : draws.classes()) {
      std::set<std::string> seen;
      for (std::uint64_t index = 0; index < 18; index += kOneIn) {
        for (const CheckedCase& asked : draws.at(contact, index)) {
          const bool is_first = asked.query().patches[0].shape == shapes[0];
          EXPECT_EQ(asked.query().patches[is_first ? 1 : 0].shape, shapes[1]);
          orders.insert(is_first);
          EXPECT_TRUE(check_truth(asked.value()));
          seen.insert(asked.value().origin.generator);
        }
      }
      EXPECT_GE(seen.size(), 6 / kOneIn) << name_of(contact);
    }
    EXPECT_GE(orders.size(), shapes[0] == shapes[1] || kOneIn > 1 ? 1U : 2U) << to_text(shapes[0]);
  }
}

TEST(Horizon, QueriesOfEndsGoOnToTheirEndsAtMost) {
  Case known = Draws(1).at(ContactClass::kVV, 1)[0].value();
  ASSERT_EQ(known.truth.witness->t, 1);
  for (MovingPatch<double>& patch : known.query.patches) give_rounded_ends(patch);
  EXPECT_TRUE(horizon_of(known, 1));
  EXPECT_FALSE(horizon_of(known, 1.5));
}

TEST(Horizon, ATimePastTheContactKeepsTheTruth) {
  const Case known = Draws(1).at(ContactClass::kVV, 1)[0].value();
  const auto t_max = horizon_of(known, 1.5);
  ASSERT_TRUE(t_max);
  EXPECT_EQ(exact(*t_max), known.truth.witness->t * Rational(3, 2));
  EXPECT_EQ(with_t_max(known, *t_max).truth.collides, true);
  Case unknown = known;
  unknown.truth = {};
  EXPECT_FALSE(horizon_of(unknown, 1.5));
}

}  // namespace
}  // namespace ccdfuzz
