// What the checker says of trimmed patches: contacts count in the closed region alone.

#include <gmock/gmock.h>

#include <cmath>

#include "certify/checker/check_box.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/miss_tree.hpp"
#include "properties/rising_triangle.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

/// The rising triangle meets the tip at (1/4, 1/4), its own trim being this.
Case trimmed(const Trim& trim) {
  Case c = rising_triangle();
  c.query.patches[0].trim = trim;
  return c;
}

/// All of the triangle but a hole, whose corner or side (from, to) is near the contact.
Trim with_hole(const Uv<double>& from, const Uv<double>& to) {
  return {{{0, 0}, {1, 0}, {0, 1}}, {from, to, {0.375, 0.375}}};
}

TEST(CheckTrim, AWitnessOutsideOfTheRegionIsRefused) {
  EXPECT_EQ(check_truth(trimmed({{{0.5, 0}, {1, 0}, {0.5, 0.5}}})).error().message(),
            "truth.witness.uv: (1/4, 1/4) lies outside of the trim of patches[0]");
}

TEST(CheckTrim, ABoxLiesInTheClosedRegion) {
  const auto box_says = [](const Trim& trim, const ContactBox& box) {
    const auto checked = check_box(trimmed(trim).query, box);
    return checked ? "accepted" : checked.error().message();
  };
  const ContactBox box = rising_box();
  const double side = 0.25 + 0x1p-10;
  const std::string refused =
      "truth.certificate.contact: the box is not known to lie in the trim of patches[0]";
  EXPECT_EQ(box_says({{{0, 0}, {1, 0}, {0, 1}}}, box), "accepted");
  EXPECT_EQ(box_says(with_hole({0.25, 0.25}, {0.375, 0.25}), box), refused);
  EXPECT_EQ(box_says(with_hole({side, 0.125}, {side, 0.375}), box), refused) << "touches";
  EXPECT_EQ(box_says({{{0, 0}, {1, 0}, {0, 1}},
                      {{0.25, 0.25}, {0.25 + 0x1p-12, 0.25}, {0.25, 0.25 + 0x1p-12}}},
                     box),
            refused)
      << "a hole in the box";
  EXPECT_EQ(box_says({{{0.5, 0}, {1, 0}, {0.5, 0.5}}}, box), refused);
  // With u as the dependent one the box has w and u in its place.
  for (const int dependent : {0, 1, 2}) {
    ContactBox turned = box;
    turned.dependent[0] = dependent;
    turned.centre[0] = dependent == 2 ? 0.5 : 0.25;
    turned.centre[1] = dependent == 1 ? 0.5 : 0.25;
    EXPECT_EQ(box_says({{{0.5, 0}, {1, 0}, {0.5, 0.5}}}, turned), refused) << dependent;
    EXPECT_NE(box_says({{{0.125, 0.125}, {0.5, 0.125}, {0.125, 0.5}}}, turned), refused)
        << dependent;
  }
}

TEST(CheckTrim, ARootProvesNothingOfATrimmedPatch) {
  const auto checked = check_contact_root(trimmed({{{0, 0}, {1, 0}, {0, 1}}}).query, {});
  ASSERT_FALSE(checked);
  Query point = rising_triangle().query;
  point.patches[1] = {Shape::point(), {{0, 0, 0.5}}, {{0, 0, 0}}};
  point.patches[0].trim = {{{0, 0}, {1, 0}, {0, 1}}};
  EXPECT_THAT(check_contact_root(point, {{-1, 2}, 0, 1}).error().message(),
              HasSubstr("does not show that the contact is in a trim"));
}

std::string tree_says(const Query& query, const Rational& until, const TreeBits& bits) {
  const auto checked = check_tree(query, until, bits.bytes());
  return checked ? "accepted" : checked.error().message();
}

TEST(CheckTrim, ALeafMaySayThatAPartIsOutside) {
  // A contact at (1/4, 1/4) and t = 1/2: of the children of the triangle the first holds it.
  const std::string refused =
      "truth.certificate.clear.tree: node 1: the part of patches[0] is not outside of its trim";
  const auto tree = [&](const Trim& trim, int side, int outside) {
    TreeBits bits;
    bits.split(0);
    for (int c = 0; c < 4; ++c) {
      c == outside ? bits.outside(side) : bits.leaf({0, 0, 1});
    }
    return tree_says(trimmed(trim).query, Rational(3, 8), bits);
  };
  const double beyond = std::nextafter(0.5, 1);
  EXPECT_EQ(tree({{{beyond, 0}, {1, 0}, {beyond, 0.25}}}, 0, 0), "accepted");
  EXPECT_EQ(tree({{{0.5, 0}, {1, 0}, {0.5, 0.25}}}, 0, 0), refused) << "they share a corner";
  EXPECT_EQ(tree({{{0.1, 0.1}, {0.2, 0.1}, {0.1, 0.2}}}, 0, 0), refused) << "a loop in the part";
  EXPECT_EQ(tree({{{0, 0}, {1, 0}, {0, 1}}}, 0, 0), refused);
  EXPECT_EQ(tree({}, 0, 0), refused) << "not trimmed";
  EXPECT_THAT(tree({{{beyond, 0}, {1, 0}, {beyond, 0.25}}}, 1, 0), HasSubstr("patches[1]"))
      << "the other patch";
  // All of a part in a hole, its edges beyond the part's.
  const Trim hole = {{{0, 0}, {1, 0}, {0, 1}}, {{0.1, 0.1}, {0.8, 0.1}, {0.1, 0.8}}};
  TreeBits deep;
  deep.split(0);
  for (int c = 0; c < 3; ++c) deep.leaf({0, 0, 1});
  deep.split(0);
  for (int c = 0; c < 3; ++c) deep.leaf({0, 0, 1});
  deep.outside(0);  // (1/4, 1/4), (1/2, 1/4), (1/4, 1/2)
  EXPECT_EQ(tree_says(trimmed(hole).query, Rational(3, 8), deep), "accepted");
}

// Means of three corners, of two coordinates each, at three corners of four parts: otherwise a file
// of 4 MiB takes half a minute.
TEST(CheckTrim, TheCornersOfPartsAreCountedAsWork) {
  const auto work_of = [](const Trim& trim) {
    TreeBits bits;
    bits.split(0);
    for (int c = 0; c < 4; ++c) bits.leaf({0, 0, 1});
    const std::uint64_t before = work_done_here();
    EXPECT_EQ(tree_says(trimmed(trim).query, Rational(3, 8), bits), "accepted");
    return work_done_here() - before;
  };
  EXPECT_GE(work_of({{{0, 0}, {1, 0}, {0, 1}}}), work_of({}) + 4 * 3 * 2 * 3 * 64);
}

TEST(CheckTrim, WhatHoldsOfTheWholePatchHoldsOfTheTrimmed) {
  const Case c = trimmed({{{0.5, 0}, {1, 0}, {0.5, 0.5}}});
  EXPECT_TRUE(check_clearance(c.query, rising_plane()));
}

}  // namespace
}  // namespace ccdfuzz
