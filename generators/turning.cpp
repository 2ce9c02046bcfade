#include "generators/turning.hpp"

#include <algorithm>
#include <cmath>

#include "base/nearest_float.hpp"
#include "base/verify.hpp"
#include "case/scale.hpp"
#include "certify/oracle/oracle.hpp"
#include "certify/oracle/rational_roots.hpp"
#include "certify/oracle/turned_points.hpp"
#include "generators/attempts.hpp"
#include "generators/bodies.hpp"
#include "generators/finalize.hpp"
#include "generators/just_missing.hpp"
#include "generators/shaped/families.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// A vector of eighths, not 0, whose square is below most.
Vec3<double> draw_axis(bool in_plane, double most, Draw& draw) {
  constexpr int kEighths = 8;
  return draw.until(
      [&] {
        const auto part = [&] {
          return draw.integer(1 - kEighths, kEighths - 1) / double{kEighths};
        };
        const double z = part();
        if (in_plane) return Vec3<double>(0, 0, z);
        const double x = part();
        return Vec3<double>(x, part(), z);
      },
      [&](const Vec3<double>& v) { return v.squaredNorm() > 0 && v.squaredNorm() < most; });
}

/// A turn about an axis that is the identity at `t`, and whose two ends have lengths of about 1.
/// The axis is shorter than 1: then from·to > 0. Numbers are of few bits, so that sums of four are
/// floats.
BodyTurn turn_about(const Vec3<double>& axis, const Vec3<double>& centre, double t, bool in_plane) {
  constexpr double kUnits = 1 << 20;
  BodyTurn turn{{}, {}, centre};
  for (const auto& [numbers, share] : {std::pair(&turn.from, -t), std::pair(&turn.to, 1 - t)}) {
    const Vec3<double> part = share * axis;
    const double rest = std::round(std::sqrt(1 - part.squaredNorm()) * kUnits) / kUnits;
    *numbers = in_plane ? std::vector{rest, part[2]} : std::vector{rest, part[0], part[1], part[2]};
  }
  return turn;
}

/// A place in or near a body.
Vec3<double> draw_centre(const Points<double>& points, bool in_plane, Draw& draw) {
  Vec3<double> centre = points[draw.below(points.size())];
  if (points.size() > 1) return (centre + points[draw.below(points.size())]) / 2;
  for (int k = 0; k < (in_plane ? 2 : 3); ++k) {
    centre[k] += draw.integer(-2, 2);
  }
  return centre;
}

/// Turns a body about the normal of the plane that it moves along, so that no height above it
/// changes. A turn is the identity at t. A spin is about the point that touches, which so moves as
/// without it.
void turn_along_plane(Case& made, size_t side, double t, bool spins, Draw& draw) {
  const Vec3<Rational>& normal = std::get<BodyClearance>(*made.truth.clearance).normal;
  Vec3<double> axis;
  for (int k = 0; k < 3; ++k) axis[k] = normal[k].get_d();
  axis *= std::ldexp(draw.coin() ? 0.5 : -0.5, -std::ilogb(axis.norm()));  // from 1/2 to 1 long
  MovingPatch<double>& body = made.query.patches[side];
  if (!spins) {
    const Vec3<double> centre = draw_centre(body.positions, false, draw);
    body.turn = turn_about((draw.coin() ? 1 : 0.5) * axis, centre, t, false);
    return;
  }
  const Vec3<double> w = draw.pick(std::array{0.25, 0.5, 1.0, 2.0, 4.0}) * axis;
  Vec3<Rational> touched(0, 0, 0);
  for (size_t i = 0; i < body.positions.size(); ++i) {
    touched += made.truth.witness->weights[side][i] * exact(body.positions[i]);
  }
  body.turn = BodyTurn{{}, {}, {0, 0, 0}, {w[0], w[1], w[2]}};
  for (int k = 0; k < 3; ++k) body.turn->centre[k] = to_double_exactly(touched[k]).value();
}

/// First the inverse of b, of length 1, and then a: the product a·b* of quaternions or complex
/// numbers.
std::vector<double> after_inverse(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() == 2) return {a[0] * b[0] + a[1] * b[1], a[1] * b[0] - a[0] * b[1]};
  const Vec3<double> u(a[1], a[2], a[3]), v(b[1], b[2], b[3]);
  const Vec3<double> w = b[0] * u - a[0] * v - cross(u, v);
  return {a[0] * b[0] + dot(u, v), w[0], w[1], w[2]};
}

/// Rotates the points of a body, and back before its turn. So at each time it is where it was, and
/// mostly its turn is nowhere the identity. It is by 0 to 3 right angles in the plane, and else by
/// one of the 12 rotations of a tetrahedron. Nothing changes if a number were no float.
void rotate_before(Query& query, size_t side, Draw& draw) {
  Query made = query;
  MovingPatch<double>& body = made.patches[side];
  if (!body.turn || body.turn->is_spin()) return;
  BodyTurn& turn = *body.turn;
  const size_t count = turn.from.size(), which = draw.below(count == 2 ? 4 : 12);
  std::vector<double> first(count, 0.0);
  first[which % count] = which < count ? 1 : -1;
  for (size_t i = 0; which >= 4 && i < count; ++i)
    first[i] = ((which - 4) >> i & 1U) == 0 ? 0.5 : -0.5;
  MovingPatch<double> still{body.shape, body.positions, {{0, 0, 0}}};
  still.turn = BodyTurn{first, first, turn.centre};
  const Points<Rational> places = points_at(still, 0).rational();
  for (size_t i = 0; i < places.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto x = to_double_exactly(places[i][k]);
      if (!x) return;
      body.positions[i][k] = *x;
    }
  }
  turn.from = after_inverse(turn.from, first);
  turn.to = after_inverse(turn.to, first);
  if (is_binary32(made)) query = std::move(made);
}

/// Bodies that do not turn and touch at t* < 1, until a time after that. Then change(case, side, t)
/// of one of them, or of both.
template <class Change>
Attempted bodies_before_one(const GeneratorOptions& options, Draw& draw, const Change& change) {
  GeneratorOptions plain = options;
  plain.kind = CaseKind::kRP;
  CCDFUZZ_TRY(Case made, framed_bodies(plain, draw));
  Query& query = made.query;
  Rational& t = made.truth.witness->t;
  if (t == 1) {  // twice as fast
    t /= 2;
    for (MovingPatch<double>& body : query.patches) body.velocities[0] *= 2;
  }
  query.t_max = draw.coin() ? 1 : (1 + round_down(t)) / 2;
  const std::uint64_t which = draw.below(3);  // the first, the second or both
  for (size_t s = 0; s < 2; ++s) {
    if (which != 1 - s) change(made, s, round_down(t));
  }
  if (!is_binary32(query)) return tl::unexpected(Discard::kRoundTrip);
  return made;
}

/// Two bodies of which one turns, or both. They touch as those of framed_bodies do. At t* < 1 a
/// turn is the identity, so that the contact is planted there whatever turns. `from` is −t*·d
/// beside a number that makes its length about 1, and `to` is (1 − t*)·d so. All numbers are
/// floats. With options.plane bodies turn by cosine and sine, else by quaternions. Kept is what the
/// oracle proves to touch at t* first, up to eps_t. RP: t* < t_max ≤ 1. RN: the same bodies with
/// t_max = t* − eps_t.
///
/// Those of turning-grazing and spinning-grazing touch as bodies of grazing_bodies_case do, and
/// turn about the normal of the plane that they move along. So they touch without depth. A spin is
/// about the point that touches. What touches is a vertex and a vertex or an edge, for else the
/// contact would begin before t*, at no rational time. NMN: they are moved apart by a step
/// (just_missing.hpp).
Attempted identical_at_contact(const GeneratorOptions& options, Draw& draw) {
  const auto change = [&](Case& made, size_t side, double t) {
    const bool spins = options.family == Family::kSpinningGrazing;
    if (is_grazing(options.family)) return turn_along_plane(made, side, t, spins, draw);
    MovingPatch<double>& body = made.query.patches[side];
    const Vec3<double> centre = draw_centre(body.positions, options.plane, draw);
    const Vec3<double> axis = draw_axis(options.plane, 0.8, draw);
    body.turn = turn_about((draw.coin() ? 1 : 0.5) * axis, centre, t, options.plane);
  };
  CCDFUZZ_TRY(Case out, bodies_before_one(options, draw, change));
  if (options.kind == CaseKind::kNMN) return just_missing(std::move(out), draw);
  const Query& query = out.query;
  const Witness witness = *out.truth.witness;
  OracleOptions limits;
  limits.known = witness;
  if (is_grazing(options.family)) {
    limits.wanted_clear = witness.t - eps_t(options).rational();
    limits.max_pops = 100;  // most take 10 to 60; what touches before takes all that there are
  }
  out.truth = decide(query, limits).truth;
  const auto& found = out.truth.witness;
  const bool is_first = found && found->t == witness.t && out.truth.clear_until &&
                        witness.t - *out.truth.clear_until <= eps_t(options).rational();
  if (!is_first) return tl::unexpected(Discard::kFirstContact);
  if (options.kind == CaseKind::kRP) return out;
  say_clear(out, round_down(witness.t) - *eps_t(options).to_double_exactly());
  CCDFUZZ_VERIFY(covers(*out.truth.clearance, exact(query.t_max)));
  return out;
}

}  // namespace

void spin_back(MovingPatch<double>& body, double t, bool in_plane, double most, Draw& draw) {
  const double longest = std::min(most, 1.0);
  const Vec3<double> axis = draw_axis(in_plane, longest * longest, draw);
  constexpr std::array kSpeeds = {0.25, 0.5, 1.0, 2.0, 3.0, kFastestSpin};
  const auto count = std::ranges::upper_bound(kSpeeds, std::max(most, 1.0)) - kSpeeds.begin();
  const Vec3<double> w = kSpeeds.at(draw.below(static_cast<std::uint64_t>(count))) * axis;
  MovingPatch<double> back = body;
  back.velocities[0] = {0, 0, 0};
  const Vec3<double> centre = draw_centre(body.positions, in_plane, draw);
  back.turn = BodyTurn{{}, {}, centre, {-w[0], -w[1], -w[2]}};
  body.turn = BodyTurn{{}, {}, centre, {w[0], w[1], w[2]}};
  const Points<Rational> before = points_at(back, exact(t)).rational();
  for (size_t i = 0; i < before.size(); ++i) {
    for (int k = 0; k < 3; ++k) body.positions[i][k] = nearest_float(before[i][k].get_d());
  }
}

/// Bodies of identical_at_contact, rotated before their turns: else code that takes a wrong centre
/// or turns the wrong way would be right at the contact.
Attempted turning_case(const GeneratorOptions& options, Draw& draw) {
  Attempted made = identical_at_contact(options, draw);
  for (size_t side = 0; made && side < 2; ++side) rotate_before(made->query, side, draw);
  return made;
}

/// The same of bodies that spin: as spin_back says, from where those of framed_bodies touch at t*.
/// So they touch near t*, and as the class says but for that rounding. Kept is what the oracle
/// proves to touch within 2^-10 of t* first. RP: t* < t_max ≤ 1. RN: t_max is eps_t or a little
/// more before the contact.
Attempted spinning_case(const GeneratorOptions& options, Draw& draw) {
  Attempted made = bodies_before_one(options, draw, [&](Case& touching, size_t side, double t) {
    spin_back(touching.query.patches[side], t, options.plane, options.most_spin, draw);
  });
  if (!made) return made;
  const Rational t = made->truth.witness->t;
  made->truth = decide(made->query).truth;
  const Truth& truth = made->truth;
  constexpr long kNearBits = 10;
  const bool is_near = truth.witness && truth.clear_until &&
                       abs(truth.witness->t - t) <= power_of_two(-kNearBits) &&
                       truth.witness->t - *truth.clear_until <= eps_t(options).rational();
  if (!is_near) return tl::unexpected(Discard::kFirstContact);
  if (options.kind == CaseKind::kRP) return made;
  const Rational step = eps_t(options).rational();
  say_clear(*made, round_down(rounded_down(*truth.clear_until, step) - step));
  CCDFUZZ_VERIFY(covers(*truth.clearance, exact(made->query.t_max)));
  return made;
}

}  // namespace ccdfuzz
