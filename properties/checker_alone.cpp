#include "properties/checker_alone.hpp"

#include <algorithm>

#include "certify/checker/check_box.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/checker/miss_tree.hpp"
#include "numeric/products.hpp"
#include "properties/rising_triangle.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// One certificate takes at most this, so that no input takes long; planes are charged for in
/// advance.
constexpr std::uint64_t kWork = 1 << 17, kPlaneWork = 1 << 28;

double draw_half(Draw& d) {
  return 0.5 * d.integer(-8, 8);
}

Vec3<double> draw_halves(Draw& d) {
  Vec3<double> point;
  for (int k = 0; k < 3; ++k) point[k] = draw_half(d);
  return point;
}

/// Two patches whose first control points, at u = v = 0, meet at the witness's time. Some are
/// rational, and of some a half counts that has this corner.
Case draw_meeting(Draw& d) {
  constexpr std::array kShapes = {Shape::point(),  Shape::curve(1),    Shape::triangle(1),
                                  Shape::curve(2), Shape::triangle(2), Shape::tensor(1, 1)};
  Case drawn;
  const double t = 0.25 * static_cast<double>(d.choose(4));
  for (MovingPatch<double>& patch : drawn.query.patches) {
    patch.shape = d.pick(kShapes);
    const bool is_rigid = d.coin();
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      patch.positions.push_back(draw_halves(d));
      patch.velocities.push_back(is_rigid && i > 0 ? patch.velocities[0] : draw_halves(d));
    }
    const bool is_rational = d.choose(3) == 3, is_trimmed = d.choose(3) == 3;
    for (int i = 0; is_rational && i < patch.shape.control_count(); ++i) {
      patch.weights.push_back(d.integer(1, 4));
    }
    if (is_trimmed && patch.shape.parameter_count() == 2)
      patch.trim = {{{0, 0}, {0.5, 0}, {0, 0.5}}};
  }
  MovingPatch<double>&one = drawn.query.patches[0], &two = drawn.query.patches[1];
  two.positions[0] = one.positions[0] + t * (one.velocities[0] - two.velocities[0]);
  drawn.truth.witness = Witness{exact(t), {}};
  return drawn;
}

/// The box about the contact of rising_triangle, with a number changed or none.
ContactBox draw_box(Draw& d) {
  ContactBox box = rising_box();
  const std::size_t place = d.below(3);
  switch (d.below(5)) {
    case 1:
      box.centre[d.below(5)] += draw_half(d) / 1024;
      break;
    case 2:
      box.radius[place] *= draw_half(d);
      break;
    case 3:
      box.inverse[place][d.below(3)] += draw_half(d) / 8;
      break;
    case 4:
      box.varied[place] = static_cast<int>(d.below(6));
      break;
    default:
      break;
  }
  return box;
}

Rational draw_time_near(Draw& d, const Rational& t) {
  constexpr std::array kFactors = {1.0, 0.0, 0.5, 1.0, 1.0, 1.5};
  const Rational scaled = t * exact(d.pick(kFactors));
  return d.choose(3) == 3 ? Rational(scaled + power_of_two(-20)) : scaled;
}

/// A linear polynomial that is 0 near t, or one that is it twice.
ContactRoot draw_root(Draw& d, const Rational& t) {
  const Rational at = draw_time_near(d, t);
  const Integer &p = at.get_num(), &q = at.get_den();
  ContactRoot root{{-p, q}, at - Rational(1, 8), at + Rational(1, 8)};
  if (d.choose(3) == 3) root.polynomial = {p * p, -2 * p * q, q * q};
  if (root.from < 0) root.from = 0;
  return root;
}

/// A plane through the point of contact at its `until`, likely to be beside both patches.
MovingPlane draw_plane(Draw& d, const Query& query, const Rational& until) {
  MovingPlane plane{until, {}, 0};
  const MovingPatch<double>& one = query.patches[0];
  plane.normal = exact(draw_halves(d));
  const Vec3<Rational> at = exact(one.positions[0]) + exact(one.velocities[0]) * until;
  plane.offset = dot(plane.normal, at);
  return plane;
}

/// Nodes in any order, or any bytes: mostly no tree at all.
std::string draw_tree(Draw& d) {
  TreeBits bits;
  for (std::uint64_t left = d.choose(2) == 2 ? d.below(6) : 0;; --left) {
    switch (left == 0 ? 0 : d.below(4)) {
      case 1:
        bits.split(d.coin() ? 1 : 0);
        break;
      case 2:
        bits.time(std::uint64_t{1} << (1 + d.below(51)));
        break;
      case 3:
        bits.outside(d.coin() ? 1 : 0);
        break;
      default: {
        TreeAxis axis{};
        for (std::int64_t& component : axis) component = d.integer(-4, 4);
        bits.leaf(axis);
      }
    }
    if (left == 0) break;
  }
  std::string bytes = bits.bytes();
  if (d.choose(3) == 3) {
    char& changed = bytes[d.below(bytes.size())];
    changed = static_cast<char>(d.choose(255));
  }
  return bytes;
}

}  // namespace

AcceptedCertificates hold_certificates(Draw& d) {
  const bool is_rising = d.choose(3) == 3;
  const Case known = is_rising ? rising_triangle() : draw_meeting(d);
  const Query& query = known.query;
  const Witness& witness = *known.truth.witness;
  for (const MovingPatch<double>& patch : query.patches) {
    show(d, "shape", patch.shape);
    show(d, "positions", patch.positions);
    show(d, "velocities", patch.velocities);
    show(d, "weights", patch.weights);
    show(d, "trim", patch.trim);
  }
  show(d, "t", witness.t);
  Rational touched = witness.t;  // by this time at the latest
  AcceptedCertificates accepted{};
  const auto& [of_witness, of_box, of_root, of_plane, of_tree, of_linear] = accepted;
  const auto note = [&](char kind, bool is_accepted) {
    accepted[kDrawnCertificates.find(kind)] = is_accepted;
    return is_accepted;
  };
  const auto hold_to_contact = [&](char kind, const Clearance& proof, bool is_accepted) {
    if (!note(kind, is_accepted)) return;
    CLAIM(!covers(proof, touched));
  };

  note('W', check_contact(query, witness, kWork).has_value());
  CLAIM(of_witness);
  if (is_rising) {
    const ContactBox box = draw_box(d);
    if (note('M', check_box(query, box, kWork).has_value())) {
      touched = std::min(touched, box.until());
    }
  }
  if (is_linear_query(query)) {
    const ContactRoot root = draw_root(d, witness.t);
    show(d, "root", root.polynomial);
    if (note('R', check_contact_root(query, root, kWork).has_value())) {
      touched = std::min(touched, root.by);
    }
  }
  const Rational until = show(d, "until", draw_time_near(d, witness.t));
  show(d, "touched", touched);
  const MovingPlane plane = draw_plane(d, query, until);
  show(d, "normal", plane.normal);
  hold_to_contact('P', plane, check_plane(query, plane, kPlaneWork).has_value());
  const std::string tree = draw_tree(d);
  show(d, "tree", AsHex{tree});
  hold_to_contact('T', MissTree{until, {}}, check_tree(query, until, tree, kWork).has_value());
  if (!is_linear_query(query)) return accepted;
  const LinearClearance linear{until, d.coin()};
  hold_to_contact('L', linear, check_linear_clearance(query, linear, kWork).has_value());
  return accepted;
}

std::vector<Property> checker_alone_claims() {
  return {{"checker.agrees_with_itself",
           "No proof of absence that the checker accepts covers a contact that it accepts, also of "
           "rational and trimmed patches",
           "src/certify/checker/check_truth.hpp", [](Draw& d) { hold_certificates(d); }}};
}

}  // namespace ccdfuzz
