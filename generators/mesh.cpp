#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/nearest_float.hpp"
#include "case/mesh.hpp"
#include "case/scale.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/attempts.hpp"
#include "generators/bodies.hpp"
#include "generators/draw_patch.hpp"
#include "generators/shaped/families.hpp"

namespace ccdfuzz {

namespace {

/// Turns points of a body into a mesh.
class MeshMaker {
 public:
  /// up: towards the other body, at right angles to the contact plane.
  MeshMaker(Query& query, size_t side, const Vec3<double>& up, Draw& draw)
      : mesh_(query.patches[side]), other_(query.patches[1 - side]), up_(up), draw_(draw) {
    way_ = other_.velocities[0] - mesh_.velocities[0];
    t_max_ = query.t_max;
    top_ = height(mesh_.positions[0]);
    double size = way_.cwiseAbs().maxCoeff() * query.t_max;
    for (const Vec3<double>& p : mesh_.positions) {
      top_ = std::max(top_, height(p));
      size = std::max(size, (p - mesh_.positions[0]).cwiseAbs().maxCoeff());
    }
    constexpr int kSteps = 8;
    unit_ = size > 0 ? std::ldexp(1.0, std::ilogb(size)) / kSteps : 1;
  }

  /// How many of the faces are in the contact. Those behind a contact that grazes are one.
  size_t make(bool grazes) {
    add_touched();
    const size_t touched = faces().size();
    if (grazes) {
      add_wall();
      drop_unused_points(mesh_);
      return touched;
    }
    if (draw_.below(4) == 0) add_grazed();
    const std::uint64_t most = touched + draw_.below(kMaxFaces + 1 - touched);
    if (draw_.below(4) == 0 && most >= touched + 3) close_tetrahedron();
    while (faces().size() < most) add_neighbour();
    drop_unused_points(mesh_);
    return touched;
  }

 private:
  std::vector<Face>& faces() const { return mesh_.faces; }
  double height(const Vec3<double>& p) const { return up_.dot(p); }
  const Vec3<double>& at(int i) const { return mesh_.positions[static_cast<size_t>(i)]; }

  static Vec3<double> rounded(const Vec3<double>& p) {
    return {nearest_float(p[0]), nearest_float(p[1]), nearest_float(p[2])};
  }

  int added(const Vec3<double>& p) const {
    mesh_.positions.push_back(rounded(p));
    mesh_.shape = Shape::hull(static_cast<int>(mesh_.positions.size()));
    return mesh_.shape.n - 1;
  }

  bool has_area(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) const {
    return (b - a).cross(Vec3<double>(c - a)).norm() > unit_ * unit_ * 0x1p-20;
  }

  /// Anywhere, and mostly behind the contact plane. Steps are no shorter than that to the next
  /// float towards 0: hardly any of shorter ones leads to another float.
  Vec3<double> anywhere_from(const Vec3<double>& from) const {
    const auto most = static_cast<float>(from.cwiseAbs().maxCoeff());
    const double unit = std::max(unit_, static_cast<double>(most - std::nextafter(most, 0.0F)));
    const Vec3<double> step = draw_integers(draw_, 8) * unit;
    const bool is_in_front = height(from + step) > top_;
    return rounded(is_in_front && draw_.below(8) > 0 ? Vec3<double>(from - step)
                                                     : Vec3<double>(from + step));
  }

  /// A point that makes a triangle with an edge: one that there is, or one that `draw_new` draws.
  template <class DrawNew>
  int third_corner(int a, int b, const DrawNew& draw_new) const {
    const std::uint64_t tries = draw_.below(3);
    for (std::uint64_t i = 0; i < tries; ++i) {
      const auto c = static_cast<int>(draw_.below(mesh_.positions.size()));
      if (has_area(at(a), at(b), at(c))) return c;
    }
    return added(
        draw_.until(draw_new, [&](const Vec3<double>& p) { return has_area(at(a), at(b), p); }));
  }

  int new_corner(int a, int b) const {
    return third_corner(a, b, [&] { return anywhere_from(at(a)); });
  }

  /// Faces of the points in the contact plane.
  void add_touched() const {
    std::vector<int> top;
    for (size_t i = 0; i < mesh_.positions.size(); ++i) {
      if (height(mesh_.positions[i]) == top_) top.push_back(static_cast<int>(i));
    }
    if (top.size() >= 3) {
      faces().push_back({top[0], top[1], top[2]});
      if (top.size() > 3) faces().push_back({top[1], top[2], top[3]});
      return;
    }
    if (top.size() == 2) {
      for (std::uint64_t left = draw_.integer(1, 2); left > 0; --left) {
        faces().push_back({top[0], top[1], new_corner(top[0], top[1])});
      }
      return;
    }
    const Vec3<double> first = draw_.until([&] { return anywhere_from(at(top[0])); },
                                           [&](const Vec3<double>& p) { return p != at(top[0]); });
    int last = added(first);
    for (std::uint64_t left = draw_.integer(1, 4); left > 0; --left) {
      const int next = new_corner(top[0], last);
      faces().push_back({top[0], last, next});
      last = next;
    }
  }

  void add_neighbour() const {
    const Face face = faces()[draw_.below(faces().size())];
    const size_t k = draw_.below(3);
    const int a = face[k], b = face[(k + 1) % 3], c = face[(k + 2) % 3];
    if (at(a) == at(b)) return;  // rounding took the edge's length
    const Vec3<double> opposite = at(a) + at(b) - at(c);
    const Vec3<double> far = at(c) + std::ldexp(1.0, draw_.integer(1, 6)) * (at(b) - at(a));
    const std::uint64_t way = draw_.below(4);
    bool is_tried = false;  // where rounding takes its area, another is drawn
    const int third = third_corner(b, a, [&] {
      const bool is_again = std::exchange(is_tried, true);
      return is_again || way > 1 ? anywhere_from(at(a)) : rounded(way == 0 ? opposite : far);
    });
    faces().push_back({b, a, third});
  }

  void close_tetrahedron() const {
    const Face base = faces()[0];
    const int a = base[0], b = base[1], c = base[2];
    const Vec3<double> normal = (at(b) - at(a)).cross(Vec3<double>(at(c) - at(a)));
    const int apex = added(
        draw_.until([&] { return anywhere_from(at(a)); },
                    [&](const Vec3<double>& p) { return std::abs(normal.dot(p - at(a))) > 0; }));
    faces().insert(faces().end(), {{b, a, apex}, {c, b, apex}, {a, c, apex}});
  }

  /// A face along the way of the other body, a little outside of what that sweeps over.
  void add_grazed() const {
    const Vec3<double> out = way_.cross(anywhere_from({0, 0, 0}));
    if (!(out.norm() > 0)) return;
    const Vec3<double> beside = out / out.norm();
    const auto& points = other_.positions;
    const Vec3<double> last =
        *std::ranges::max_element(points, {}, [&](const Vec3<double>& p) { return beside.dot(p); });
    const double gap = std::ldexp(unit_, -draw_.integer(0, 12));
    const Vec3<double> near = last + (other_.radius + gap) * beside;
    const auto share = [&] { return draw_.integer(-4, 8) / 8.0; };
    const double from = share(), middle = share();
    const Vec3<double> ways = way_ * std::ldexp(1.0, draw_.integer(0, 4));
    const int a = added(near + from * way_), b = added(near + from * way_ + ways);
    faces().push_back({a, b, added(near + middle * way_ + 8 * unit_ * beside)});
  }

  /// A face around a place where a point of the other body comes late.
  void add_wall() const {
    const Vec3<double> p = other_.positions[draw_.below(other_.positions.size())];
    const Vec3<double> middle = p + t_max_ * draw_.integer(12, 14) / 16.0 * way_;
    const auto step = [&]() -> Vec3<double> { return draw_integers(draw_, 8) * unit_; };
    const auto [a, b] = draw_.until(
        [&] {
          const Vec3<double> first = step();
          return std::pair(first, step());
        },
        [&](const auto& sides) {
          const Vec3<double> normal = sides.first.cross(sides.second);
          return std::abs(normal.dot(way_)) > normal.norm() * way_.norm() / 4;
        });
    const int first = added(middle + a), second = added(middle + b);
    faces().push_back({first, second, added(middle - a - b)});
  }

  MovingPatch<double>& mesh_;
  const MovingPatch<double>& other_;
  Vec3<double> up_, way_;
  double t_max_, top_, unit_;
  Draw& draw_;
};

/// Turns faces so that they are there, or not: the first ones are if wanted, the others mostly.
void turn_faces(Query& query, size_t side, size_t first, bool wanted, Draw& draw) {
  MovingPatch<double>& mesh = query.patches[side];
  const std::vector<size_t> there = faces_there(query);
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    const bool is_there = std::ranges::find(there, f) != there.end();
    const bool is_wanted = f < first || draw.below(4) > 0 ? wanted : !wanted;
    if (is_there != is_wanted) std::swap(mesh.faces[f][1], mesh.faces[f][2]);
  }
}

/// Whether the first contact is of the first faces, without depth, and not at 0.
/// And the body passes by a thousandth of its way or more through the last face.
bool is_hidden_by_a_graze(const Query& query, const Witness& first, size_t side, size_t touched) {
  Query grazed = query;
  grazed.patches[side].faces.resize(touched);
  Rational sum = 0;
  for (size_t i = 0; i < first.weights[side].size(); ++i) {
    const bool is_touched = std::ranges::any_of(grazed.patches[side].faces, [&](const Face& face) {
      return std::ranges::count(face, static_cast<int>(i)) > 0;
    });
    if (is_touched) sum += first.weights[side][i];
  }
  const Vec3<double> way = query.patches[0].velocities[0] - query.patches[1].velocities[0];
  return first.t > 0 && sum == 1 && depth_until(grazed, query.t_max) == 0.0 &&
         depth_until(of_face(query, touched), query.t_max) >= 0x1p-10 * query.t_max * way.norm();
}

}  // namespace

/// A convex body and a mesh (case/mesh.hpp). They touch as two bodies of framed_bodies do, of which
/// one gave its points to the mesh. What is in contact is inside of a face, on an edge of two
/// faces, or a corner of a fan. More faces are put to edges that there are. Their third corners are
/// those of others, across the edge in the face's plane, far away along the edge, or anywhere. So
/// there are strips, folded sheets and long thin triangles, and some close a tetrahedron. In one
/// mesh of four the body nearly grazes a face before. All numbers are floats.
///
/// The oracle decides. Kept is what touches at t* first, or does not. One-sided, the faces that are
/// touched are fronts. In half of the cases RN, which end after t*, the body comes from behind.
///
/// Those of mesh-grazing touch as bodies of grazing_bodies_case do. A last face is across the way
/// of the body. Kept is what touches another face first, without depth, and then passes well
/// through the last. Whoever stops at the face that is touched first misses that. One-sided, all
/// faces are fronts that can be.
Attempted mesh_case(const GeneratorOptions& options, Draw& draw) {
  const bool has_fronts_alone = is_one_sided(options.family);
  const bool is_behind = has_fronts_alone && options.kind == CaseKind::kRN && draw.coin();
  GeneratorOptions plain = options;
  if (is_behind) plain.kind = CaseKind::kRP;
  if (!plain.bodies.empty()) plain.bodies.push_back({1, kMaxControls, RadiusRule::kZero});
  const size_t side = draw.below(2);
  Attempted made =
      draw.until([&] { return framed_bodies(plain, draw); },
                 [&](const Attempted& tried) {
                   if (!tried) return true;
                   const MovingPatch<double>& other = tried->query.patches[1 - side];
                   return tried->query.patches[side].radius == 0 &&
                          is_one_of(options.bodies, other.positions.size(), other.radius > 0);
                 });
  if (!made) return made;
  Query& query = made->query;
  const Vec3<Rational>& normal = std::get<BodyClearance>(*made->truth.clearance).normal;
  Vec3<double> up;
  for (int k = 0; k < 3; ++k) up[k] = (side == 0 ? 1 : -1) * normal[k].get_d();
  const bool grazes = is_grazing(options.family);
  const size_t touched = MeshMaker(query, side, up, draw).make(grazes);
  query.patches[side].one_sided = has_fronts_alone;
  const size_t all = query.patches[side].faces.size();
  if (has_fronts_alone) turn_faces(query, side, grazes ? all : touched, !is_behind, draw);
  if (!is_binary32(query)) return tl::unexpected(Discard::kRoundTrip);
  const std::optional<Witness> planted = made->truth.witness;
  made->truth = decide(query).truth;
  const bool touches = options.kind == CaseKind::kRP;
  const auto& found = made->truth.witness;
  if (grazes) {
    if (found && is_hidden_by_a_graze(query, *found, side, touched)) return made;
    return tl::unexpected(Discard::kFirstContact);
  }
  if (made->truth.collides != touches || (touches && found->t != planted->t)) {
    return tl::unexpected(Discard::kFirstContact);
  }
  return made;
}

}  // namespace ccdfuzz
