// Certificate T: its bytes, and what the checker says of good ones and bad ones.
#include "certify/checker/miss_tree.hpp"

#include <gtest/gtest.h>

#include "certify/checker/check_tree.hpp"
#include "properties/rising_triangle.hpp"

namespace ccdfuzz {
namespace {

constexpr TreeAxis kUp = {0, 0, 1};

std::string verdict(const Query& query, const Rational& until, const std::string& tree) {
  const auto checked = check_tree(query, until, tree);
  return checked ? "accepted" : checked.error().message();
}

std::string leaf(const TreeAxis& axis) {
  TreeBits bits;
  bits.leaf(axis);
  return bits.bytes();
}

TEST(CheckTree, TheWindowIsClosed) {
  const Query query = rising_triangle().query;
  EXPECT_EQ(verdict(query, Rational(1, 2) - Rational(1, 1000000007), leaf(kUp)), "accepted");
  EXPECT_EQ(verdict(query, Rational(1, 2), leaf(kUp)),
            "truth.certificate.clear.tree: node 0: axis (0, 0, 1) does not separate");
  EXPECT_EQ(verdict(query, Rational(-1, 2), leaf(kUp)),
            "truth.certificate.clear.until: -1/2 is negative");
}

TEST(CheckTree, NoAxisAtAllSeparatesNothing) {
  EXPECT_NE(verdict(rising_triangle().query, Rational(3, 8), leaf({0, 0, 0})), "accepted");
}

/// Patch 1 starts above and patch 2 moves past it: no axis separates at both ends.
Query passing_points() {
  Query query;
  query.patches[0] = {Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
  query.patches[1] = {Shape::curve(1), {{1, 0, -1}, {2, 0, -1}}, {{0, 0, 2}, {0, 0, 2}}};
  return query;
}

TEST(CheckTree, EachPartOfTheTimeHasItsOwnAxis) {
  TreeBits bits;
  bits.time(kTimeSteps / 2);
  bits.leaf({2, 0, -1});
  bits.leaf({2, 0, 1});
  EXPECT_EQ(verdict(passing_points(), Rational(1), bits.bytes()), "accepted");
}

TEST(CheckTree, CountsNodesAndNamesTheOneThatIsWrong) {
  const Query query = rising_triangle().query;
  const auto tree = [](const TreeAxis& last) {
    TreeBits bits;
    bits.time(kTimeSteps / 2);
    bits.leaf({1, 1, 20});
    bits.split(0);
    for (int c = 0; c < 4; ++c) bits.leaf(c < 3 ? kUp : last);
    return bits.bytes();
  };
  EXPECT_EQ(*check_tree(query, Rational(3, 8), tree(kUp)), 7U);
  EXPECT_EQ(verdict(query, Rational(3, 8), tree({0, 0, -1})),
            "truth.certificate.clear.tree: node 6: axis (0, 0, -1) does not separate");
  EXPECT_EQ(verdict(query, Rational(3, 8), tree(kUp) + '\0'),
            "truth.certificate.clear.tree: goes on after its last node");
  EXPECT_EQ(verdict(query, Rational(3, 8), ""), "truth.certificate.clear.tree: ends within node 0");
}

TEST(CheckTree, APointHasNoParts) {
  TreeBits bits;
  bits.split(0);
  bits.leaf({1, 0, 0});
  EXPECT_EQ(verdict(passing_points(), Rational(1), bits.bytes()),
            "truth.certificate.clear.tree: node 0: a point has no parts");
}

}  // namespace
}  // namespace ccdfuzz
