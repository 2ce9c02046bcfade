// Which number of a query a NaN or an infinity stands in for.
#include "method/plugin/probes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace ccdfuzz {
namespace {

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
