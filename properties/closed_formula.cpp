#include "properties/closed_formula.hpp"

#include <algorithm>
#include <cmath>

#include "base/verify.hpp"
#include "certify/oracle/rational_roots.hpp"
#include "generators/round.hpp"
#include "numeric/products.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

using ExactVec = Vec3<Rational>;
using ccdfuzz::cross, ccdfuzz::dot;  // beside those of other files

enum class Core { kPoint, kLine, kRing, kPlane };

/// A piece of a surface, in coordinates of which z goes out of it and y along its axis.
struct Piece {
  Core core;
  Profile profile = {{}, {}, 0, 0};
  QuarterCircle turn = {};
  RoundSide side = {Shape::point(), {Whole{}}, {}, {}};
  std::int64_t size = 0;  ///< of a triangle
  WholeFrame frame = {};
  Whole centre = {}, velocity = {};

  std::int64_t ring() const { return kPerProfile * profile.ring; }
  /// The distance from the centre of where z goes out.
  std::int64_t height() const { return kPerProfile * profile.distance; }
};

Piece draw_round_piece(Core core, Draw& draw) {
  Piece out{core};
  if (core == Core::kLine) {
    out.profile = straight_profile(false, draw);
  } else {
    const std::int64_t ring = core == Core::kRing ? 5 * draw.integer(1, 4) : 0;
    const std::int64_t radius = draw.integer(1, 6);
    out.profile = circular_profile(ring, radius, draw);
  }
  out.turn = draw.pick(kQuarterCircles);
  out.side = revolve(out.profile, out.turn);
  return out;
}

Piece draw_other_piece(Core first, Draw& draw) {
  const std::uint64_t kind = first == Core::kRing ? 0 : draw.below(4);
  if (kind == 1) return {Core::kPoint};
  if (kind > 1) return draw_round_piece(kind == 2 ? Core::kPoint : Core::kLine, draw);
  Piece out{Core::kPlane};
  out.size = 125 * draw.integer(1, 16);
  out.side = {Shape::triangle(1),
              {out.size * Whole{-3, -1, 0}, out.size * Whole{3, -1, 0}, out.size * Whole{0, 2, 0}},
              {},
              {}};
  return out;
}

/// Turned about an axis, and five times as long.
WholeFrame turned(const WholeFrame& frame, std::size_t axis, Draw& draw) {
  constexpr std::array<std::array<std::int64_t, 2>, 5> kTurns = {
      {{5, 0}, {4, 3}, {4, -3}, {3, 4}, {3, -4}}};
  const auto& [c, s] = draw.pick(kTurns);
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  WholeFrame out{{}, 5 * frame.length};
  out.axes[axis] = 5 * frame.axes[axis];
  out.axes[i] = c * frame.axes[i] + s * frame.axes[j];
  out.axes[j] = c * frame.axes[j] + -s * frame.axes[i];
  return out;
}

ExactVec exact_of(const Whole& p) {
  return {static_cast<long>(p[0]), static_cast<long>(p[1]), static_cast<long>(p[2])};
}

ExactVec multiple(const Rational& k, const ExactVec& p) {
  return {k * p[0], k * p[1], k * p[2]};
}

/// The part of a way from core to core that is at right angles to the lines or planes which the
/// cores are, times `scale`.
struct Across {
  std::vector<ExactVec> along;  ///< one line, or two directions
  Rational scale = 1;

  explicit Across(const std::array<Piece, 2>& pieces) {
    for (const Piece& piece : pieces) {
      if (piece.core == Core::kLine) along.push_back(exact_of(piece.frame.axes[1]));
      if (piece.core == Core::kPlane) {
        along = {exact_of(piece.frame.axes[0]), exact_of(piece.frame.axes[1])};
      }
    }
    if (along.size() == 2 && normal() == ExactVec(0, 0, 0)) along.pop_back();
    if (along.size() == 1) scale = dot(along[0], along[0]);
    if (along.size() == 2) scale = dot(normal(), normal());
  }
  ExactVec normal() const { return cross(along[0], along[1]); }
  ExactVec operator()(const ExactVec& way) const {
    if (along.empty()) return way;
    if (along.size() == 2) return multiple(dot(way, normal()), normal());
    return multiple(scale, way) - multiple(dot(way, along[0]), along[0]);
  }
};

/// Where the centre of the circle is that first comes to a plane, seen from the torus's centre.
ExactVec nearest_of_ring(const Piece& torus, const Piece& plane) {
  const ExactVec axis = exact_of(torus.frame.axes[1]), normal = exact_of(plane.frame.axes[2]);
  const ExactVec out = multiple(dot(normal, axis), axis) - multiple(dot(axis, axis), normal);
  const auto length = rational_root(dot(out, out));
  CCDFUZZ_VERIFY(length.has_value());
  return multiple(torus.frame.length * torus.ring() / *length, out);
}

/// Whether a surface is touched inside of its patch at two times, and so between them. outward: the
/// ways out of the core then; places: where of the core, from its centre.
bool is_inside(const Piece& piece, const std::array<ExactVec, 2>& outward,
               const std::array<ExactVec, 2>& places) {
  const auto local = [&](const ExactVec& p, std::size_t k) {
    return Rational(dot(p, exact_of(piece.frame.axes[k])));
  };
  if (piece.core == Core::kPlane) {
    return std::ranges::all_of(places, [&](const ExactVec& p) {
      const Rational x = local(p, 0), y = local(p, 1);
      const Rational size = piece.frame.length * piece.frame.length * piece.size;
      return y > -size && x + y < 2 * size && y - x < 2 * size;
    });
  }
  if (piece.side.shape.kind == ShapeKind::kPoint) return true;
  const auto& first = piece.profile.points.front();
  const auto& last = piece.profile.points.back();
  if (piece.core == Core::kLine) {
    const bool ends_after = std::ranges::all_of(places, [&](const ExactVec& p) {
      const Rational unit = piece.frame.length * piece.frame.length * kPerProfile;
      return first[1] * unit < local(p, 1) && local(p, 1) < last[1] * unit;
    });
    if (!ends_after) return false;
  }
  // How far out of the axis: at least this, by one of these directions.
  constexpr std::array<std::array<int, 2>, 4> kDirections = {{{5, 0}, {4, 3}, {3, 4}, {0, 5}}};
  return std::ranges::any_of(kDirections, [&](const auto& direction) {
    return std::ranges::all_of(outward, [&](const ExactVec& out) {
      const Rational c = local(out, 2), s = local(out, 0);
      const auto& from = piece.turn.points.front();
      const auto& to = piece.turn.points.back();
      const Rational a = from[0] * c + from[1] * s, b = to[0] * c + to[1] * s;
      if (a <= 0 || b <= 0) return false;
      if (piece.core == Core::kLine) return true;
      const Rational away = (direction[0] * a + direction[1] * b) / 25, up = local(out, 1);
      const std::int64_t ring = piece.profile.ring;
      return (first[0] - ring) * away + first[1] * up > 0 &&
             (last[0] - ring) * away + last[1] * up > 0;
    });
  });
}

std::optional<std::array<Rational, 2>> first_times(const ClosedFormula& formula) {
  Rational before = 0, by = exact(formula.query.t_max);
  if (!formula.is_within(0, by)) {
    const Rational square = dot(formula.rate, formula.rate);
    if (square == 0) return std::nullopt;
    const Rational nearest = -dot(formula.way, formula.rate) / square;
    if (nearest <= 0 || nearest >= by || !formula.is_within(0, nearest)) return std::nullopt;
    by = nearest;
  }
  for (int halvings = 0; halvings < 64; ++halvings) {
    const Rational middle = (before + by) / 2;
    (formula.is_within(0, middle) ? by : before) = middle;
  }
  return {{before, by}};
}

}  // namespace

bool ClosedFormula::is_within(const Rational& distance, const Rational& t) const {
  const ExactVec at = way + multiple(t, rate);
  const Rational most = scale * (reach + distance);
  return dot(at, at) <= most * most;
}

ClosedFormula draw_closed_formula(bool separation, bool of_point, Draw& draw) {
  const Core first =
      of_point ? Core::kLine : draw.pick(std::array{Core::kPoint, Core::kLine, Core::kRing});
  std::array<Piece, 2> pieces = {draw_round_piece(first, draw), {Core::kPoint}};
  if (!of_point) pieces[1] = draw_other_piece(first, draw);
  const WholeFrame frame = draw_right_angles(draw);
  pieces[0].frame = {{25 * frame.axes[0], 25 * frame.axes[1], 25 * frame.axes[2]},
                     25 * frame.length};
  // An axis stays parallel to a plane. Two axes may be so, or at any angle.
  const bool is_straight = first == Core::kLine && pieces[1].core >= Core::kLine;
  const bool is_parallel = is_straight && (pieces[1].core == Core::kPlane || draw.coin());
  const WholeFrame once = turned(frame, 1, draw);
  WholeFrame& other = pieces[1].frame;
  other = turned(once, is_parallel ? 1 : is_straight ? 2 : 0, draw);
  for (std::size_t k = 1; k < 3; ++k) other.axes[k] = -1 * other.axes[k];

  const std::int64_t gap = separation ? draw.integer(1, 1000) : 0;
  const std::int64_t reach = pieces[0].height() + pieces[1].height() + gap;
  const std::int64_t aside = draw.choose(3) == 3 ? 2 * reach : reach / 2;
  const bool head_on = of_point || draw.coin();
  Whole way = head_on ? Whole{} : any_whole(draw, aside);
  way[2] = reach + draw.integer(1, 1000);
  Whole rate = head_on ? Whole{} : any_whole(draw, 300);
  rate[2] = -draw.integer(100, 1500);
  const Whole common = draw.coin() ? Whole{} : any_whole(draw, 500);
  const Whole place = draw.coin() ? Whole{} : any_whole(draw, 5000);
  const int unit = draw.integer(-32, 0);
  const std::uint64_t mover = draw.below(2);

  ClosedFormula out;
  out.query.t_max = 4;
  out.query.separation = std::ldexp(static_cast<double>(gap * pieces[0].frame.length), unit);
  for (std::size_t s = 0; s < 2; ++s) {
    Piece& piece = pieces[s];
    const std::int64_t sign = s == 0 ? -1 : 1;
    piece.centre = pieces[0].frame(s == 0 ? place : place + way);
    piece.velocity = pieces[0].frame(s == mover ? common + sign * rate : common);
    MovingPatch<double>& patch = out.query.patches[s];
    patch.shape = piece.side.shape;
    patch.weights = piece.side.weights;
    for (Whole p : piece.side.points) {
      p[2] += piece.height();
      patch.positions.push_back(times_power(piece.frame(p) + piece.centre, unit));
      patch.velocities.push_back(times_power(piece.velocity, unit));
    }
  }

  const Across across(pieces);
  ExactVec from = exact_of(pieces[0].centre);
  if (first == Core::kRing) from += nearest_of_ring(pieces[0], pieces[1]);
  const ExactVec apart = exact_of(pieces[1].centre) - from;
  const ExactVec speed = exact_of(pieces[1].velocity) - exact_of(pieces[0].velocity);
  out.way = across(apart);
  out.rate = across(speed);
  out.scale = across.scale;
  const std::int64_t radii = reach - pieces[0].ring();
  out.reach = static_cast<long>(radii * pieces[0].frame.length);
  // Boxes of precision 2^-14 are as large as 2^-14 of the ways along a patch, of up to 4 radii,
  // and in 4 units of time. Twice that for both.
  out.slack = power_of_two(-11) * static_cast<long>((reach + 4 * 1500) * pieces[0].frame.length);
  suppose(!out.is_within(0, 0));
  // A torus must be on the side of the plane where its nearest place was sought.
  suppose(first != Core::kRing || dot(apart, exact_of(other.axes[2])) < 0);
  out.times = first_times(out);
  if (!out.times) return out;  // so their parts do not touch

  std::array<std::array<ExactVec, 2>, 2> outward, places;  // of each piece at both times
  for (std::size_t k = 0; k < 2; ++k) {
    const Rational& t = (*out.times)[k];
    outward[0][k] = out.way + multiple(t, out.rate);
    outward[1][k] = -outward[0][k];
    const ExactVec all = apart + multiple(t, speed);
    const ExactVec along = all - multiple(1 / out.scale, outward[0][k]);
    places[0][k] = places[1][k] = ExactVec(0, 0, 0);
    if (is_straight && !is_parallel && across.along.size() == 2) {
      const Rational share = dot(cross(along, across.along[1]), across.normal()) / out.scale;
      places[0][k] = multiple(share, across.along[0]);
    } else if (first == Core::kLine && pieces[1].core != Core::kPlane) {
      places[0][k] = along;
    }
    places[1][k] = places[0][k] - along;
  }
  for (std::size_t s = 0; s < 2; ++s) suppose(is_inside(pieces[s], outward[s], places[s]));
  return out;
}

}  // namespace ccdfuzz
