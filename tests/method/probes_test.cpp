// Which number of a query a NaN or an infinity stands in for.
#include "method/plugin/probes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "certify/oracle/oracle.hpp"
#include "method/domain.hpp"

namespace ccdfuzz {
namespace {

/// A box that spins falls past a rod that turns.
Query turning_bodies() {
  Query query;
  query.patches[0] = {Shape::hull(2), {{3, 1, 8}, {3, 1, 9}}, {{0.5, 0, -8}}};
  query.patches[1] = {Shape::hull(2), {{0, 1, 0}, {4, 1, 0}}, {{0, 0, 0}}};
  query.patches[0].turn = BodyTurn{{}, {}, {3, 1, 8.5}, {0.5, 0.25, 1}};
  query.patches[1].turn = BodyTurn{{1, 0, 0, 0}, {1, 0.25, 0, 0.5}, {2, 1, 0}};
  return query;
}

TEST(DecoyQuery, IsAnotherOfWhichTheSameIsTrueAndPromised) {
  Query falling;
  falling.patches[0] = {Shape::point(), {{0.25, 0.5, 1}}, {{0, 0, -2}}};
  falling.patches[1] = {Shape::triangle(1), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {}};
  falling.patches[1].ends = falling.patches[1].positions;
  const Domain promised{.scale = 3, .binary32 = true, .ordinary = true};
  for (const Query& query : {falling, turning_bodies()}) {
    const Query decoy = decoy_query(query, promised);
    EXPECT_FALSE(decoy == query);
    const Truth truth = decide(query).truth, of_decoy = decide(decoy).truth;
    EXPECT_EQ(of_decoy.collides, truth.collides);
    EXPECT_EQ(of_decoy.contact_by(), truth.contact_by());
    EXPECT_EQ(promised.broken_by({decoy, of_decoy, {}, {}}),
              promised.broken_by({query, truth, {}, {}}));
  }
}

TEST(DecoyQuery, AtTwiceTheSpeedTouchesAfterHalfTheTime) {
  Query query;
  query.patches[0] = {Shape::hull(2), {{3, 1, 8}, {3, 1, 9}}, {{0.5, 0, -8}}};
  query.patches[1] = {Shape::hull(2), {{0, 1, 0}, {8, 1, 0}}, {{0, 0, 0}}};
  query.patches[0].radius = 0.5;
  EXPECT_EQ(*decide(decoy_query(query, {})).truth.contact_by() * 2,
            *decide(query).truth.contact_by());
  query.patches[0].turn = BodyTurn{{}, {}, {3, 1, 8.5}, {0, 0.25, 1}};
  const Query spinning = decoy_query(query, {});
  EXPECT_EQ(spinning.t_max, 0.5);
  EXPECT_EQ(spinning.patches[0].turn->spin, (std::vector<double>{0, -0.5, 2}));
  const Truth truth = decide(query).truth, of_decoy = decide(spinning).truth;
  ASSERT_EQ(truth.collides, true);
  EXPECT_NEAR(of_decoy.contact_by()->get_d() * 2, truth.contact_by()->get_d(), 0x1p-36);
}

TEST(DecoyQuery, HasAnotherTimeOfImpactIfThatMayBeAsked) {
  Query query;
  query.patches[0] = {Shape::point(), {{0, 0, 1}}, {{0, 0, -1}}};
  query.patches[1] = {Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
  EXPECT_EQ(decoy_query(query, Domain{.scale = 1}).t_max, 0.5);
  EXPECT_EQ(decoy_query(query, Domain{.scale = 0}).t_max, 1);
}

TEST(PoisonedQuery, EveryCoordinateIsPoisonedInTurnAndNothingElse) {
  std::set<std::string> where;
  for (int i = 1; i <= 200; ++i) {
    Query query;
    query.patches[0] = {Shape::point(), {{-1.0 / i, 100, 0}}, {{1, 0, 0}}};
    query.patches[1] = {Shape::point(), {{0, 100, 0}}, {{0, 0, 0}}};
    const PoisonedQuery poisoned = poisoned_query(query);
    EXPECT_EQ(poisoned.where, poisoned_query(query).where);
    where.insert(poisoned.where);
    int changed = 0;
    int finite = 0;
    for (size_t side = 0; side < 2; ++side) {
      for (int k = 0; k < 3; ++k) {
        for (const auto& [before, after] :
             {std::pair{query.patches[side].positions[0][k],
                        poisoned.query.patches[side].positions[0][k]},
              std::pair{query.patches[side].velocities[0][k],
                        poisoned.query.patches[side].velocities[0][k]}}) {
          if (!(before == after)) ++changed;
          if (std::isfinite(after)) ++finite;
        }
      }
    }
    EXPECT_EQ(changed, 1) << poisoned.where;
    EXPECT_EQ(finite, 11) << poisoned.where;
  }
  EXPECT_EQ(where.size(), 36U);  // 2 patches, 2 kinds, 3 coordinates, 3 values
}

TEST(PoisonedQuery, HasItInRadiiTurnsAndSpinsToo) {
  Query query;
  query.patches[0] = {Shape::hull(1), {{0, 0, 8}}, {{0, 0, -1}}};
  query.patches[1] = {Shape::hull(2), {{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}}};
  query.patches[0].radius = 1;
  query.patches[0].turn = BodyTurn{{}, {}, {0, 0, 8}, {0.5, 0, 1}};
  query.patches[1].turn = BodyTurn{{1, 0}, {1, 0.5}, {0, 0, 0}};
  std::set<std::string> fields;
  for (int i = 1; i <= 200; ++i) {
    query.t_max = 1.0 / i;
    const std::string where = poisoned_query(query).where;
    fields.insert(where.substr(0, where.find(" = ")));
  }
  for (const char* field : {"patches[0].radius", "patches[0].spin.velocity[1]",
                            "patches[1].turn.from[0]", "patches[1].turn.to[1]"}) {
    EXPECT_TRUE(fields.contains(field)) << field;
  }
}

}  // namespace
}  // namespace ccdfuzz
