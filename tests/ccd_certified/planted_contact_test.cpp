#include <cmath>
#include <map>

#include "bezier/blossom.hpp"
#include "bezier/exact_patch.hpp"
#include "bezier/random_patch.hpp"
#include "ccd/certified/tdibm_c.hpp"

namespace ccdfuzz {
namespace {

/// Two random moving patches of any shapes with an exact contact at a random dyadic time and place.
struct Planted {
  Query query;
  double t = 0;
  std::array<Uv<Dyadic>, 2> uv;
};

Planted any_planted() {
  Planted out;
  const Dyadic t(*rc::gen::inRange(0, 17), -4);
  std::array<MovingPatch<Dyadic>, 2> patches;
  std::array<Vec3<Dyadic>, 2> at;
  for (size_t s = 0; s < 2; ++s) {
    const Shape shape = *any_shape(3);
    patches[s] = {shape, any_points(shape), any_points(shape)};
    out.uv[s] = any_uv(shape);
    at[s] = evaluate(patches[s], out.uv[s], t);
  }
  for (Vec3<Dyadic>& p : patches[1].positions) {
    for (int k = 0; k < 3; ++k) p[k] += at[0][k] - at[1][k];
  }
  for (size_t s = 0; s < 2; ++s) {
    out.query.patches[s] = {patches[s].shape, *to_doubles(patches[s].positions),
                            *to_doubles(patches[s].velocities)};
  }
  out.t = *t.to_double_exactly();
  out.query.t_max = out.t * *rc::gen::element(1.0, 1 + 0x1p-30, 1.5, 2.0);
  return out;
}

/// Cells of any depths may meet: pairs of a child and an undivided patch lose no contact either.
RC_GTEST_PROP(PairSplit, KeepsAContactOfCellsOfUnequalDepth, ()) {
  constexpr int kFinest = 5;
  const Planted planted = any_planted();
  certified::PairSplit split;
  split.take(planted.query);
  split.begin(kFinest);
  const double t = std::ldexp(planted.t, -split.query().time);
  const certified::CellPair whole{{0, split.query().t_max}, {}, {}, {}};
  std::array<certified::CellPair, certified::PairSplit::kMostPairs> kept;
  int count = split.split(whole, certified::PairSplit::kAll, kept);
  const size_t side = *rc::gen::inRange<size_t>(0, 2);
  std::map<certified::CellTree::Node, certified::CellPair> seeds;
  for (int i = 0; i < count; ++i) {
    const certified::CellTree::Node cell = kept[static_cast<size_t>(i)].cells[side];
    certified::CellPair& seed = seeds[cell] = whole;
    seed.cells[side] = cell;
    seed.depths[side] = 1;
  }
  std::vector<certified::CellPair> level;
  for (const auto& [cell, seed] : seeds) level.push_back(seed);
  constexpr size_t kMost = 2000;  // patches may coincide
  for (int depth = 0; depth < kFinest && level.size() < kMost; ++depth) {
    std::vector<certified::CellPair> next;
    for (const certified::CellPair& pair : level) {
      count = split.split(pair, certified::PairSplit::kAll, kept);
      for (int i = 0; i < count; ++i) {
        const certified::CellPair& child = kept[static_cast<size_t>(i)];
        // The coarser cell alone was split.
        RC_ASSERT(child.depths[0] == depth + 1 && child.depths[1] == depth + 1);
        if (child.window.lo <= t && t <= child.window.hi) next.push_back(child);
      }
    }
    level = std::move(next);
    RC_ASSERT(!level.empty());
  }
}

}  // namespace
}  // namespace ccdfuzz
