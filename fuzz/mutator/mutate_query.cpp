#include "fuzz/mutator/mutate_query.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/nearest_float.hpp"
#include "base/verify.hpp"
#include "case/mesh.hpp"

namespace ccdfuzz {

namespace {

/// What one change is made of: a body or patch, what it may take parts of, and where.
struct BodyChange {
  Query& query;
  MovingPatch<double>& hull;
  const MovingPatch<double>& donor;
  Draw& draw;
  size_t point;  ///< a place in hull.positions
  int k;         ///< a coordinate

  double& number() const { return draw.below(3) == 0 ? velocity()[k] : hull.positions[point][k]; }
  bool is_body() const { return hull.shape.kind == ShapeKind::kHull; }
  /// Or the end.
  Vec3<double>& velocity() const { return hull.moves()[is_body() ? 0 : point]; }
  const Vec3<double>& other_point() const {
    return donor.positions[draw.below(donor.positions.size())];
  }
};

/// n·2^e, |n| ≤ 8, least ≤ e ≤ most.
double draw_step(Draw& draw, int least, int most) {
  const int exponent = draw.integer(least, most);
  return std::ldexp(draw.integer(-8, 8), exponent);
}

/// A few floats away.
void nudge(const BodyChange& c) {
  double& x = c.number();
  const std::uint64_t steps = c.draw.below(4) + 1;
  const float to = c.draw.coin() ? HUGE_VALF : -HUGE_VALF;
  for (std::uint64_t i = 0; i < steps; ++i) {
    x = static_cast<double>(std::nextafter(static_cast<float>(x), to));
  }
}

void shift_number(const BodyChange& c) {
  const double step = draw_step(c.draw, -8, 2);
  c.number() += step;
}

void align(const BodyChange& c) {
  c.hull.positions[c.point][c.k] = c.other_point()[c.k];
}

void simplify_number(const BodyChange& c) {
  double& x = c.number();
  x = c.draw.coin() ? std::round(x) : 0;
}

void scale_velocity(const BodyChange& c) {
  c.velocity() *= std::ldexp(1.0, c.draw.integer(-6, 6));
}

void change_radius(const BodyChange& c) {
  if (!c.is_body()) return;
  double& r = c.hull.radius;
  const std::uint64_t way = c.draw.below(4);
  const double factor = std::ldexp(1.0, c.draw.integer(-4, 4));
  r = way == 0 ? 0 : way == 1 ? c.donor.radius : way == 2 ? factor : factor * r;
}

void drop_point(const BodyChange& c) {
  if (!c.is_body() || c.hull.positions.size() == 1) return;
  ccdfuzz::drop_point(c.hull, c.point);
}

void add_point(const BodyChange& c) {
  if (!c.is_body() || c.hull.positions.size() == size_t{kMaxControls}) return;
  Vec3<double> p = c.hull.positions[c.point];
  p[c.k] += draw_step(c.draw, -4, 2);
  c.hull.positions.push_back(p);
}

void stretch(const BodyChange& c) {
  const double factor = std::ldexp(1.0, c.draw.integer(-8, 4));
  const double centre = c.hull.positions[c.point][c.k];
  for (Vec3<double>& p : c.hull.positions) p[c.k] = centre + factor * (p[c.k] - centre);
}

void shift_body(const BodyChange& c) {
  const double by = draw_step(c.draw, -10, 2);
  for (Vec3<double>& p : c.hull.positions) p[c.k] += by;
}

void shift_all(const BodyChange& c) {
  const double by = std::ldexp(1.0, c.draw.integer(4, 14));
  for (MovingPatch<double>& hull : c.query.patches) {
    for (Vec3<double>& p : hull.positions) p[c.k] += by;
  }
}

/// The points of another body, about a point of this one.
void splice_body(const BodyChange& c) {
  if (!c.is_body()) return;
  const Vec3<double> by = c.hull.positions[c.point] - c.other_point();
  c.hull.positions = c.donor.positions;
  c.hull.faces = c.donor.faces;
  c.hull.one_sided = c.donor.one_sided;
  for (Vec3<double>& p : c.hull.positions) p += by;
}

void swap_bodies(const BodyChange& c) {
  std::swap(c.query.patches[0], c.query.patches[1]);
}

void change_end(const BodyChange& c) {
  c.query.t_max *= std::ldexp(1.0, c.draw.integer(-2, 2));
}

/// A body that turns stops turning, turns as the other does or the other way round, or about
/// another point or axis.
void change_turn(const BodyChange& c) {
  std::optional<BodyTurn>& turn = c.hull.turn;
  const std::optional<BodyTurn> before = turn;
  const std::uint64_t way = c.draw.below(5);
  if (way == 0) {
    turn.reset();
  } else if (way == 1) {
    turn = c.donor.turn;
  } else if (way == 2) {
    std::swap(turn->from, turn->to);
    for (double& x : turn->spin) x = -x;
  } else if (way == 3) {
    turn->centre = c.hull.positions[c.point];
  } else {
    const bool is_of_spin = turn->is_spin() && c.draw.coin();
    double& x = is_of_spin ? turn->spin[static_cast<size_t>(c.k)] : turn->centre[c.k];
    x += draw_step(c.draw, -4, 2);
  }
  if (turn && fault_of(*turn)) turn = before;
}

/// A mesh loses a face, gets another, or one of its faces turns round or gets another corner.
void change_faces(const BodyChange& c) {
  std::vector<Face>& faces = c.hull.faces;
  const auto any_corner = [&] { return static_cast<int>(c.draw.below(c.hull.positions.size())); };
  const size_t f = c.draw.below(faces.size());
  const std::uint64_t way = c.draw.below(4);
  Face face = faces[f];
  if (way == 0) {
    if (faces.size() > 1) faces.erase(faces.begin() + static_cast<long>(f));
  } else if (way == 1) {
    std::swap(faces[f][1], faces[f][2]);
  } else {
    face[static_cast<size_t>(c.k)] = any_corner();
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) return;
    if (way == 2) faces[f] = face;
    if (way == 3 && faces.size() < kMaxFaces) faces.push_back(face);
  }
}

/// One mesh at most, without a radius, and nothing that turns beside it.
void settle_meshes(Query& query) {
  if (!has_mesh(query)) return;
  MovingPatch<double>&mesh = query.patches[mesh_side(query)],
  &other = query.patches[1 - mesh_side(query)];
  other.faces.clear();
  other.one_sided = false;
  mesh.radius = 0;
  mesh.turn.reset();
  other.turn.reset();
}

constexpr std::array kBodyChanges = {nudge,          shift_number,  align,      simplify_number,
                                     scale_velocity, change_radius, drop_point, add_point,
                                     stretch,        shift_body,    shift_all,  splice_body,
                                     swap_bodies,    change_end};

void change_once(Query& mutant, const Query& other, Draw& draw) {
  MovingPatch<double>& hull = mutant.patches[draw.below(2)];
  const MovingPatch<double>& donor = other.patches[draw.below(2)];
  const size_t point = draw.below(hull.positions.size());
  const bool is_of_turn = hull.turn && draw.below(4) == 0;  // what does not turn draws as before
  const bool is_of_faces = !hull.faces.empty() && draw.below(4) == 0;
  const auto change = is_of_turn    ? change_turn
                      : is_of_faces ? change_faces
                                    : draw.pick(kBodyChanges);
  change({mutant, hull, donor, draw, point, static_cast<int>(draw.below(3))});
}

/// x, or the largest float of its sign if it is past it.
double within_floats(double x) {
  constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
  return std::clamp(x, -kMost, kMost);
}

template <class Change>
void change_numbers(Query& query, const Change& change) {
  for (MovingPatch<double>& hull : query.patches) {
    for_each_coordinate(hull, [&](double& x) { x = change(x); });
    for_each_turn_number(hull, [&](double& x) { x = change(x); });
  }
  query.t_max = change(query.t_max);
}

}  // namespace

Query mutate_query(const Query& query, const Query& other, Draw& draw) {
  constexpr std::uint64_t kMost = 4;
  Query mutant = query;
  for (std::uint64_t left = 1 + draw.below(kMost); left > 0; --left) {
    change_once(mutant, other, draw);
    change_numbers(mutant, within_floats);  // lest the next subtracts infinities
  }
  for (MovingPatch<double>& patch : mutant.patches) {
    if (patch.shape.kind != ShapeKind::kHull) continue;
    patch.shape = Shape::hull(static_cast<int>(patch.positions.size()));
  }
  settle_meshes(mutant);
  if (is_past_motion(mutant, mutant.t_max)) mutant.t_max = 1;
  change_numbers(mutant, nearest_float);
  for (MovingPatch<double>& hull : mutant.patches) {
    if (hull.turn && fault_of(*hull.turn)) hull.turn.reset();  // a spin that is too fast as floats
  }
  CCDFUZZ_VERIFY(is_valid(mutant));
  return mutant;
}

}  // namespace ccdfuzz
