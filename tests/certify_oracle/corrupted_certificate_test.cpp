// Certificates of the oracle, spoilt so that they are wrong for certain: the checker refuses each.
// What only might be wrong (a bit of an axis that separates with room to spare) is of no use here.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "certify/checker/check_box.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/checker/miss_tree.hpp"
#include "certify/oracle/build_tree.hpp"
#include "certify/oracle/oracle.hpp"
#include "files/case_json.hpp"
#include "mixed_cases.hpp"

namespace ccdfuzz {
namespace {

constexpr double kUlp = 0x1p-52;

std::vector<TreeNode> nodes_of(const std::string& tree) {
  std::vector<TreeNode> nodes;
  TreeReader reader(tree);
  while (!reader.at_end()) nodes.push_back(*reader.next());
  return nodes;
}

std::string bytes_of(const std::vector<TreeNode>& nodes) {
  TreeBits bits;
  for (const TreeNode& node : nodes) {
    if (node.kind == TreeNodeKind::kLeaf) bits.leaf(node.axis);
    if (node.kind == TreeNodeKind::kSplit) bits.split(node.side);
    if (node.kind == TreeNodeKind::kTime) bits.time(node.time);
    if (node.kind == TreeNodeKind::kOutside) bits.outside(node.side);
  }
  return bits.bytes();
}

class Corrupted : public testing::Test {
 protected:
  /// Positive cases with a contact at their t_max that is proven, and none before clear_until.
  template <class Visit>
  void for_each_positive(int count, const Visit& visit) {
    for (const ContactClass contact : kContactClasses) {
      for (int i = 0; i < count; ++i) {
        GeneratorOptions o;
        o.contact = contact;
        o.construction = i % 2 == 0 ? Construction::kOneSided : Construction::kPaper;
        visit(generate(o, static_cast<std::uint64_t>(i)).value);
      }
    }
  }
  void refused(bool accepted, const char* how, const Case& c) {
    ++refusals;
    EXPECT_FALSE(accepted) << how << "\n" << to_json(c);
  }
  int refusals = 0;
};

TEST_F(Corrupted, Trees) {
  int trees = 0;
  for_each_positive(4, [&](const Case& c) {
    const Rational contact = c.truth.witness->t;
    const Rational until = contact * Rational(63, 64);
    const auto tree = build_miss_tree(c.query, until, 20'000);
    if (!tree) return;
    ++trees;
    const auto accepted = [&](const std::string& bytes, const Rational& to) {
      return check_tree(c.query, to, bytes).has_value();
    };
    ASSERT_TRUE(accepted(*tree, until)) << to_json(c);
    const std::vector<TreeNode> nodes = nodes_of(*tree);
    ASSERT_EQ(bytes_of(nodes), *tree);

    refused(accepted(*tree, contact), "a step too late: until is the contact itself", c);
    refused(accepted(*tree, contact * 2), "twice too late", c);
    refused(accepted(*tree + '\0', until), "a trailing byte", c);
    refused(accepted(tree->substr(0, tree->size() - 1), until), "a missing byte", c);
    refused(accepted("", until), "no byte", c);
    Case swapped = c;
    std::swap(swapped.query.patches[0], swapped.query.patches[1]);
    const bool same_split = nodes.size() > 1;
    if (!same_split) {
      refused(check_tree(swapped.query, until, *tree).has_value(), "patches swapped", c);
    }
    // Of the nodes a few suffice: the first, the last and some in between.
    for (size_t n = 0; n < nodes.size(); n += 1 + nodes.size() / 5) {
      std::vector<TreeNode> spoilt = nodes;
      if (nodes[n].kind == TreeNodeKind::kLeaf) {
        for (auto& x : spoilt[n].axis) x = -x;
        refused(accepted(bytes_of(spoilt), until), "a leaf's axis turned round", c);
        spoilt[n].axis = {};
        refused(accepted(bytes_of(spoilt), until), "a leaf without an axis", c);
        spoilt = nodes;
        spoilt.erase(spoilt.begin() + static_cast<std::ptrdiff_t>(n));
        refused(accepted(bytes_of(spoilt), until), "a leaf missing", c);
        spoilt = nodes;
        spoilt.insert(spoilt.begin() + static_cast<std::ptrdiff_t>(n), nodes[n]);
        refused(accepted(bytes_of(spoilt), until), "a leaf too many", c);
      } else if (nodes[n].kind == TreeNodeKind::kSplit) {
        spoilt.erase(spoilt.begin() + static_cast<std::ptrdiff_t>(n));
        refused(accepted(bytes_of(spoilt), until), "a split missing", c);
      }
    }
    // No damage whatever makes a tree prove what is false.
    std::mt19937_64 random(static_cast<std::uint64_t>(trees));
    for (int k = 0; k < 10; ++k) {
      std::string damaged = *tree;
      for (std::uint64_t flips = random() % 3; flips > 0; --flips) {
        const size_t bit = random() % (8 * damaged.size());
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
      }
      refused(accepted(damaged, contact), "bits flipped, and until at the contact", c);
    }
  });
  EXPECT_GE(trees, 20);
  EXPECT_GE(refusals, 400);
}

TEST_F(Corrupted, Witnesses) {
  for_each_positive(3, [&](const Case& c) {
    const Witness good = *c.truth.witness;
    ASSERT_TRUE(check_contact(c.query, good));
    for (const int sign : {-1, 1}) {
      Witness w = good;
      w.t += sign * exact(kUlp);
      refused(check_contact(c.query, w).has_value(), "t off by an ulp", c);
      for (const size_t s : {size_t{0}, size_t{1}}) {
        for (const size_t k : {size_t{0}, size_t{1}}) {
          w = good;
          w.uv[s][k] += sign * exact(kUlp);
          refused(check_contact(c.query, w).has_value(), "a parameter off by an ulp", c);
        }
      }
    }
  });
  EXPECT_GE(refusals, 100);
}

TEST_F(Corrupted, Boxes) {
  RandomQueries random(11);
  int boxes = 0;
  for (int i = 0; i < 150 && boxes < 15; ++i) {
    const Query query = random.query(3, i % 2 == 0);
    const Truth truth = decide(query).truth;
    if (!truth.contact_box || !truth.clear_until) continue;
    ++boxes;
    const Case c = {query, truth, {}, {}};
    const ContactBox good = *truth.contact_box;
    const auto spoilt = [&](const char* how, const auto& change) {
      ContactBox box = good;
      change(box);
      refused(check_box(query, box).has_value(), how, c);
    };
    ASSERT_TRUE(check_box(query, good));
    if (good.varied[2] == ContactBox::kTime) {
      const double early = round_down(*truth.clear_until) - 2 * good.radius[2];
      spoilt("where it is proven clear", [&](ContactBox& b) { b.centre[4] = early; });
      spoilt("before t = 0", [&](ContactBox& b) { b.centre[4] = -b.centre[4]; });
    }
    spoilt("a matrix of zeros", [](ContactBox& b) { b.inverse = {}; });
    spoilt("a singular matrix", [](ContactBox& b) { b.inverse[1] = b.inverse[0]; });
    spoilt("rows swapped", [](ContactBox& b) { std::swap(b.inverse[0], b.inverse[2]); });
    spoilt("a row turned round", [](ContactBox& b) {
      for (double& y : b.inverse[1]) y = -y;
    });
    spoilt("a row twice as large", [](ContactBox& b) {
      for (double& y : b.inverse[2]) y *= 2.5;
    });
    spoilt("a radius of nothing", [](ContactBox& b) { b.radius[0] = 0; });
    spoilt("a negative radius", [](ContactBox& b) { b.radius[2] = -b.radius[2]; });
    spoilt("a radius larger than the domain", [](ContactBox& b) {
      for (double& r : b.radius) r = 2;
    });
    spoilt("out of the domain", [](ContactBox& b) {
      if (b.varied[0] < 4) b.centre[static_cast<size_t>(b.varied[0])] = 1;
    });
    spoilt("unknowns out of order", [](ContactBox& b) { std::swap(b.varied[0], b.varied[1]); });
    spoilt("an unknown twice", [](ContactBox& b) { b.varied[1] = b.varied[0]; });
    spoilt("radii too small for the residual", [](ContactBox& b) {
      for (const int v : b.varied) {
        double& x = b.centre[static_cast<size_t>(v)];
        x += x > 0.5 ? -0x1p-30 : 0x1p-30;
      }
      b.radius.fill(0x1p-40);
    });
  }
  EXPECT_GE(boxes, 10);
  EXPECT_GE(refusals, 120);
}

TEST_F(Corrupted, Planes) {
  int planes = 0;
  for_each_positive(4, [&](const Case& c) {
    const Truth truth = decide(c.query).truth;
    if (!truth.clearance || !std::holds_alternative<MovingPlane>(*truth.clearance)) return;
    ++planes;
    const MovingPlane good = std::get<MovingPlane>(*truth.clearance);
    const auto spoilt = [&](const char* how, const auto& change) {
      MovingPlane plane = good;
      change(plane);
      refused(check_plane(c.query, plane).has_value(), how, c);
    };
    ASSERT_TRUE(check_plane(c.query, good));
    const Rational least = exact(0x1p-1074);
    spoilt("a step too late", [&](MovingPlane& p) { p.until += least; });
    spoilt("a plane through patch 1", [&](MovingPlane& p) { p.offset += least; });
    spoilt("a plane through patch 2", [&](MovingPlane& p) { p.offset -= least; });
    spoilt("no normal", [](MovingPlane& p) { p.normal = {}; });
    spoilt("sides swapped", [](MovingPlane& p) {
      for (Rational& x : p.normal) x = -x;
      p.offset = -p.offset;
    });
    spoilt("normal turned", [](MovingPlane& p) {
      for (Rational& x : p.normal) x = -x;
    });
    spoilt("before the beginning", [](MovingPlane& p) { p.until = -1; });
  });
  EXPECT_GE(planes, 8);
  EXPECT_GE(refusals, 56);
}

}  // namespace
}  // namespace ccdfuzz
