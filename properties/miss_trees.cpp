#include <algorithm>
#include <cmath>

#include "certify/checker/check_tree.hpp"
#include "certify/checker/miss_tree.hpp"
#include "generators/draw_patch.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

void move_along(Query& query, int axis, double by) {
  for (Vec3<double>& p : query.patches[1].positions) p[axis] += by;
}

/// One leaf for all of [0, 1]: it proves absence of contact iff patch 1 stays below patch 2 on its
/// axis; touching at one end is no proof.
void check_leaf(Draw& d) {
  Query query = draw_small_query(d, 2);
  TreeAxis axis{};
  const auto along = static_cast<int>(d.choose(2));
  for (int k = 0; k < 3; ++k) {
    axis[static_cast<std::size_t>(k)] = k == along ? 1 : d.integer(-3, 3);
  }
  const auto height = [&](const Vec3<double>& p) {
    return static_cast<double>(axis[0]) * p[0] + static_cast<double>(axis[1]) * p[1] +
           static_cast<double>(axis[2]) * p[2];  // exact: few bits
  };
  double overlap = -HUGE_VAL;
  for (const double t : {0.0, 1.0}) {
    double most = -HUGE_VAL, least = HUGE_VAL;
    for (const Vec3<double>& p : query.patches[0].at(t)) most = std::max(most, height(p));
    for (const Vec3<double>& p : query.patches[1].at(t)) least = std::min(least, height(p));
    overlap = std::max(overlap, most - least);
  }
  const double gap = show(d, "gap", std::ldexp(d.integer(-2, 2), -10));
  move_along(query, along, overlap + gap);
  TreeBits tree;
  tree.leaf(axis);
  show(d, "tree", AsHex{tree.bytes()});
  show(d, "query", query);
  CLAIM(check_tree(query, Rational(1), tree.bytes()).has_value() == (gap > 0));
}

/// Draws a subtree for parts that any leaf of this axis separates.
struct TreeDraw {
  Draw& choices;
  const Query& query;
  TreeAxis axis;
  TreeBits bits;

  void subtree(std::uint64_t lo, std::uint64_t hi, int depth) {
    const std::uint64_t kind = depth == 0 ? 0 : choices.choose(2);
    if (kind == 1 && hi - lo > 1) {
      const std::uint64_t time = lo + 1 + choices.choose(hi - lo - 2);
      bits.time(time);
      subtree(lo, time, depth - 1);
      subtree(time, hi, depth - 1);
      return;
    }
    const std::size_t side = choices.choose(1);
    const int parts = query.patches[side].shape.child_count();
    if (kind != 2 || parts == 1) {
      bits.leaf(axis);
      return;
    }
    bits.split(static_cast<int>(side));
    for (int c = 0; c < parts; ++c) subtree(lo, hi, depth - 1);
  }
};

/// Patches far apart: every complete tree of leaves that separate them is accepted. A tree is
/// refused if it is cut off or goes on after its end. So it is if a time is outside of its window,
/// or if a leaf does not separate.
void check_tree_form(Draw& d) {
  Query query = draw_small_query(d, 2);
  move_along(query, 0, 64);
  enum class Change : std::uint8_t { kNone, kCutOff, kMoreNodes, kMoreBytes, kTime, kLeaf };
  const auto change = static_cast<Change>(d.choose(5));
  TreeDraw draw{d, query, {1, 0, 0}, {}};
  TreeBits& bits = draw.bits;
  constexpr int kDepth = 3;
  if (change == Change::kTime) {
    // [0, 1] is cut at `first`; the earlier half, or the later one, is cut where it is not.
    const std::uint64_t first = 1 + d.choose(kTimeSteps - 2);
    const bool earlier = d.coin();
    const std::uint64_t second =
        earlier ? first + d.choose(kTimeSteps - 1 - first) : 1 + d.choose(first - 1);
    bits.time(first);
    if (!earlier) bits.leaf(draw.axis);
    bits.time(second);
    for (int leaf = earlier ? 3 : 2; leaf > 0; --leaf) bits.leaf(draw.axis);
  } else if (change == Change::kLeaf) {
    bits.time(1 + d.choose(kTimeSteps - 2));
    bits.leaf(draw.axis);
    bits.leaf({-1, 0, 0});
  } else {
    draw.subtree(0, kTimeSteps, kDepth);
  }
  if (change == Change::kMoreNodes) draw.subtree(0, kTimeSteps, kDepth);
  std::string bytes = bits.bytes();
  if (change == Change::kCutOff) bytes.pop_back();
  if (change == Change::kMoreBytes) bytes.push_back('\0');
  show(d, "change", static_cast<int>(change));
  show(d, "tree", AsHex{bytes});
  show(d, "query", query);
  CLAIM(check_tree(query, Rational(1), bytes).has_value() == (change == Change::kNone));
}

}  // namespace

std::vector<Property> miss_trees_claims() {
  return {
      {"checker.refuses_touching_leaves",
       "A leaf of a miss tree is accepted iff its axis separates at both ends, touching being none",
       "src/certify/checker/check_tree.hpp", check_leaf},
      {"checker.refuses_malformed_trees",
       "A whole tree of separating leaves is accepted, and refused once it is cut off, goes on, or "
       "has a time outside of its window",
       "src/certify/checker/miss_tree.hpp", check_tree_form},
  };
}

}  // namespace ccdfuzz
