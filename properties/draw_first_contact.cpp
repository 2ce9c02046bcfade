#include "properties/draw_first_contact.hpp"

#include <cmath>

#include "generators/quadratic.hpp"
#include "generators/separated.hpp"
#include "generators/shaped/families.hpp"
#include "properties/answers.hpp"

namespace ccdfuzz {

namespace {

/// The extents of a patch's control points along all coordinates, at any time up to t.
Vec3<double> extents(const MovingPatch<double>& patch, double t) {
  Vec3<double> widths(0, 0, 0);
  for (const double at : {0.0, t}) {
    const Points<double> points = patch.at(at);
    Vec3<double> lo = points[0], hi = points[0];
    for (const Vec3<double>& p : points) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
    widths = widths.cwiseMax(hi - lo);
  }
  return widths;
}

}  // namespace

FirstContact draw_first_contact(Draw& choices, bool apart) {
  const ContactClass contact = choices.pick(kContactClasses);
  // Coarse boxes are no good for flat patches.
  ContactScene scene = touching(contact, {kQuadratic, kQuadratic}, choices, 1);
  if (choices.coin()) scene.t_max = 2;
  // Between corners of steep patches, no plane of either is as far from both as the corners are.
  // Fast ones are in contact but shortly where a box of the search is.
  if (apart) {
    const int steep = choices.integer(0, 4);
    const Dyadic fast(1, choices.integer(3, 6));
    for (ContactSide& side : scene.sides) {
      for (Vec3<Dyadic>& p : side.points) p[2] = p[2].scaled(steep);
      for (Vec3<Dyadic>& v : side.rates) v[2] += v[2].sign() < 0 ? -fast : fast;
    }
  }
  Placement placement = random_placement(choices);
  placement.shift = choices.vector(20, -16);
  const Case made = supposed(to_case(scene, placement, choices));
  const double t = *scene.t.to_double_exactly();
  FirstContact out;
  out.query = made.query;
  out.truth.collides = true;
  out.truth.witness = made.truth.witness;
  const Vec3<Dyadic>& towards = placement.frame.normal;
  if (apart) {
    const int exponent = choices.integer(-12, 3);
    suppose(move_apart(out.query, towards * Dyadic(1, exponent)));
  }
  double reach = 0;
  std::array<double, 2> rate = {-HUGE_VAL, HUGE_VAL};
  Vec3<double> normal;
  for (int k = 0; k < 3; ++k) normal[k] = towards[k].rational().get_d();
  for (std::size_t s = 0; s < 2; ++s) {
    const MovingPatch<double>& patch = made.query.patches[s];
    const Vec3<double> width = kQuadratic.n * kFinePrecision * extents(patch, t);
    // At a distance the nearest points of two boxes may lie in any direction.
    reach += apart ? normal.norm() * width.norm() : normal.cwiseAbs().dot(width);
    for (const Vec3<double>& v : patch.velocities) {
      const double along = normal[0] * v[0] + normal[1] * v[1] + normal[2] * v[2];
      rate[s] = s == 0 ? std::max(rate[s], along) : std::min(rate[s], along);
    }
  }
  out.early = reach / (rate[1] - rate[0]);
  return out;
}

void claim_not_early(const std::string& method, const FirstContact& drawn, Draw& draw,
                     const SearchOptions& search) {
  const Answer answer = asked(draw, method, drawn.query, search);
  suppose(answer.verdict != Verdict::kUndecided);
  const double t = show(draw, "contact at", drawn.truth.witness->t.get_d());
  show(draw, "explained", drawn.early);
  CLAIM(answer.verdict == Verdict::kHit);
  CLAIM(t - *answer.toi <= drawn.early);
}

}  // namespace ccdfuzz
