#include "finds/content_address.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

Query two_points(double x, double t_max = 1) {
  Query query;
  query.patches[0] = {Shape::point(), {{x, 0, 0}}, {{0, 0, 0}}};
  query.patches[1] = {Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
  query.t_max = t_max;
  return query;
}

TEST(ContentAddress, IsTheSameForEver) {
  // Corpora are named by it: a change here would duplicate every entry of every corpus.
  EXPECT_EQ(content_address(two_points(1)), "30af54fe121008ed22a08137f88c566d");
}

TEST(ContentAddress, TellsEveryBitApart) {
  const std::string address = content_address(two_points(0));
  EXPECT_NE(address, content_address(two_points(-0.0)));
  EXPECT_NE(address, content_address(two_points(0x1p-1074)));
  EXPECT_NE(address, content_address(two_points(0, 0x1.0000000000001p0)));
  Query swapped = two_points(1);
  std::swap(swapped.patches[0], swapped.patches[1]);
  EXPECT_NE(content_address(two_points(1)), content_address(swapped));
  Query other_shape;  // the same 24 coordinates
  for (auto& patch : other_shape.patches) patch = {Shape::tensor(1, 1), {}, {}};
  for (auto& patch : other_shape.patches) patch.positions.resize(4, {0, 0, 0});
  for (auto& patch : other_shape.patches) patch.velocities.resize(4, {0, 0, 0});
  const std::string tensor = content_address(other_shape);
  for (auto& patch : other_shape.patches) patch.shape = Shape::curve(3);
  EXPECT_NE(tensor, content_address(other_shape));
}

// Both have a number for each coordinate of a control point.
TEST(ContentAddress, TellsEndsFromVelocities) {
  Query ends = two_points(1);
  std::swap(ends.patches[0].ends, ends.patches[0].velocities);
  EXPECT_NE(content_address(ends), content_address(two_points(1)));
}

TEST(CaseSize, CountsBitsAndThenTheSpreadOfExponents) {
  EXPECT_EQ(size_of(two_points(0)), (CaseSize{1, 0}));  // t_max's
  EXPECT_EQ(size_of(two_points(0, 0)), (CaseSize{0, 0}));
  EXPECT_EQ(size_of(two_points(3)), (CaseSize{3, 0}));
  EXPECT_EQ(size_of(two_points(-0x1p-1074)), size_of(two_points(0x1p1023)));
  EXPECT_EQ(size_of(two_points(0x1.0000000000001p0)), (CaseSize{54, 0}));
  Query query = two_points(0x1p-1074);
  query.patches[1].velocities[0][2] = 0x1.8p1000;
  EXPECT_EQ(size_of(query), (CaseSize{4, 2074}));
  EXPECT_LT((CaseSize{3, 2000}), (CaseSize{4, 0}));
}

}  // namespace
}  // namespace ccdfuzz
