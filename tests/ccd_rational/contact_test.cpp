// Whatever the queries, a contact that is known exactly is never lost: not by any test of a pair of
// cells that holds it, not by the search, and not by a proof of its absence.
#include "bezier/blossom.hpp"
#include "bezier/exact_patch.hpp"
#include "ccd/rational/gap.hpp"
#include "ccd/rational/pair_test.hpp"
#include "ccd/rational/proves_clear.hpp"
#include "ccd/rational/tdibm_rational.hpp"
#include "ccd_rational/random_query.hpp"

namespace ccdfuzz {
namespace {

struct Contact {
  Query query;
  Rational t;
  std::array<Uv<Dyadic>, 2> uv;
};

/// Two lattice patches of any shapes, moved exactly so that they touch at a dyadic time and dyadic
/// parameters. t_max is at the contact or past it.
Contact any_contact() {
  Contact c;
  const RandomCoordinates coordinates{
      *rc::gen::element(RandomCoordinates::kLattice, RandomCoordinates::kDyadic)};
  c.query = any_query(3, coordinates);
  if (*rc::gen::inRange(0, 4) == 0) {  // zero relative velocity: contact all the time
    for (MovingPatch<double>& patch : c.query.patches) {
      std::fill(patch.velocities.begin(), patch.velocities.end(), Vec3<double>(1, -2, 0.5));
    }
  }
  const Dyadic t(*rc::gen::inRange(0, 9), -3);
  c.t = t.rational();
  std::array<Vec3<Dyadic>, 2> at;
  for (size_t side = 0; side < 2; ++side) {
    const MovingPatch<double>& patch = c.query.patches[side];
    c.uv[side] = any_uv(patch.shape);
    at[side] = evaluate(exact_patch<Dyadic>(patch), c.uv[side], t);
  }
  for (Vec3<double>& p : c.query.patches[1].positions) {
    for (int k = 0; k < 3; ++k) {
      const auto moved = (Dyadic::exact(p[k]) + at[0][k] - at[1][k]).to_double_exactly();
      RC_PRE(moved.has_value());
      p[k] = *moved;
    }
  }
  c.query.t_max = round_up(Rational(c.t * *rc::gen::element(Rational(1), Rational(3, 2))));
  if (c.t == 0 && *rc::gen::inRange(0, 2) == 0) c.query.t_max = 1;
  // A common power of two changes nothing, down to the least double and up to the largest.
  const int scale = *rc::gen::element(0, 0, 0, -900, -600, -540, -85, 80, 500, 900);
  for (MovingPatch<double>& patch : c.query.patches) {
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      for (Vec3<double>& p : *points) {
        for (int k = 0; k < 3; ++k) p[k] = std::ldexp(p[k], scale);
      }
    }
  }
  RC_LOG() << to_text(c.query.patches[0].shape) << " " << to_text(c.query.patches[1].shape)
           << ", t* = " << c.t << ", t_max = " << to_hex(c.query.t_max) << ", scale 2^" << scale
           << "\n";
  return c;
}

/// The children of `parent`, and which of them holds the parameters.
CellFamily children_holding(const Shape& shape, const Cell& parent, const Uv<Dyadic>& uv) {
  CellFamily f;
  f.size = static_cast<size_t>(shape.child_count());
  const Uv<Rational> at = {uv[0].rational(), uv[1].rational()};
  for (int c = 0; c < shape.child_count(); ++c) {
    f.parts[static_cast<size_t>(c)] = parent.child(shape, c);
    if (contains(f.parts[static_cast<size_t>(c)], shape, at)) f.chosen = c;
  }
  return f;
}

RC_GTEST_PROP(Contact, NoWindowExcludesItsTime, ()) {
  const Contact c = any_contact();
  exact_ccd::PairTest test;
  test.begin(c.query);
  std::array<CellFamily, 2> families;
  Window window{0, c.query.t_max};
  for (int depth = 0; depth <= 14; ++depth) {
    for (size_t side = 0; side < 2; ++side) {
      const Shape& shape = c.query.patches[side].shape;
      if (depth > 0) families[side] = children_holding(shape, families[side].cell(), c.uv[side]);
      test.prepare(static_cast<int>(side), families[side].all());
    }
    const auto cut = test.test(families[0].chosen, families[1].chosen, window);
    RC_LOG() << "depth " << depth << "\n";
    RC_ASSERT(cut.has_value());
    RC_ASSERT(exact(cut->lo) <= c.t);
    RC_ASSERT(c.t <= exact(cut->hi));
    window = *cut;
  }
}

RC_GTEST_PROP(Contact, IsHitInTimeByTheSearch, ()) {
  const Contact c = any_contact();
  SearchOptions options;
  options.precision = 0x1p-6;
  options.max_pops = 2'000;
  TdibmRational method;
  const Answer answer = method.answer(c.query, options);
  RC_ASSERT(answer.verdict != Verdict::kMiss);
  RC_ASSERT(exact(*answer.toi) <= c.t);
}

RC_GTEST_PROP(Contact, ForbidsAProofOfItsAbsence, ()) {
  const Contact c = any_contact();
  RC_ASSERT(!proves_clear(c.query, c.t));
}

}  // namespace
}  // namespace ccdfuzz
