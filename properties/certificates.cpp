#include <algorithm>
#include <cmath>

#include "bezier/exact_patch.hpp"
#include "certify/checker/check_box.hpp"
#include "certify/checker/check_plane.hpp"
#include "generators/draw_contact.hpp"
#include "generators/draw_patch.hpp"
#include "generators/round.hpp"
#include "generators/shaped/families.hpp"
#include "numeric/products.hpp"
#include "properties/query_kind.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// A plane, or a patch that it separates, with one thing changed. The plane is turned round, or
/// later, or on the wrong side of a patch by less than any move. A patch or one of its corners is
/// beyond the plane, or the patches do not come nearer. Round patches stay as they are. Those at a
/// separation may have to be a float farther apart.
void check_changed_plane(Draw& d) {
  const bool is_round = d.coin();
  std::vector<ContactClass> contacts(kContactClasses.begin(), kContactClasses.end());
  if (is_round) {
    std::erase_if(contacts, [](ContactClass contact) {
      return !is_made(Family::kRound, contact, CaseKind::kRP);
    });
  }
  const ContactClass contact = contacts[d.choose(contacts.size() - 1)];
  const bool apart = is_round && d.coin();
  Case changed = is_round ? draw_round_case(contact, apart, d)
                          : supposed(to_case(touching(contact, {kQuadratic, kQuadratic}, d),
                                             random_placement(d), d));
  auto plane = std::get<MovingPlane>(*changed.truth.clearance);
  auto& patches = changed.query.patches;
  // The last three change the patches.
  enum class Change : std::uint8_t {
    kNone,
    kFarther,
    kOffset,
    kLater,
    kTurned,
    kSide,
    kCorner,
    kNotNearer
  };
  const Change last = is_round ? Change::kTurned : Change::kNotNearer;
  const auto change = static_cast<Change>(d.choose(static_cast<std::uint64_t>(last)));
  const std::uint64_t side = d.choose(1);
  const Rational little = power_of_two(d.integer(is_round ? -60 : -16, 3));
  const auto move_beyond = [&](Vec3<double>& p, const Rational& by) {
    for (int k = 0; k < 3; ++k) {
      const Rational step = (side == 0 ? -1 : 1) * by * plane.normal[k];
      p[k] = supposed(to_double_exactly(exact(p[k]) + step));
    }
  };
  switch (change) {
    case Change::kNone:
      break;
    case Change::kFarther:
      changed.query.separation = std::nextafter(changed.query.separation, HUGE_VAL);
      break;
    case Change::kSide:
      for (Vec3<double>& p : patches[side].positions) move_beyond(p, little);
      break;
    case Change::kCorner: {
      const std::size_t corner = d.pick(std::array<std::size_t, 3>{0, 2, 5});
      const Vec3<Rational> at = exact_patch<Rational>(patches[side]).at(plane.until)[corner];
      const Rational height = dot(plane.normal, at) - plane.offset;
      const Rational by = power_of_two(d.integer(0, 8));
      suppose(by * dot(plane.normal, plane.normal) > abs(height));
      move_beyond(patches[side].positions[corner], by);
      break;
    }
    case Change::kOffset:
      plane.offset += side == 0 ? little : Rational(-little);
      break;
    case Change::kLater:
      plane.until += little;
      break;
    case Change::kTurned:
      plane.normal = -plane.normal;
      plane.offset = -plane.offset;
      break;
    case Change::kNotNearer:
      patches[side].velocities = patches[1 - side].velocities;
      break;
  }
  changed.truth = {};
  changed.truth.clearance = plane;
  show(d, "change", static_cast<int>(change));
  show(d, "case", changed);
  CLAIM(check_plane(changed.query, plane).has_value() == (change == Change::kNone));
}

/// A contact box about a point that falls through a flat triangle. In each of the unknowns u, v and
/// t the contact is off the centre by a number of its own. The box proves the contact iff no number
/// is larger than the radius, and its matrix is regular. It must also stay inside of the triangle
/// and in t ≥ 0.
void check_contact_box(Draw& d) {
  constexpr int kSteps = 16;
  const auto steps = [](std::int64_t n) { return std::ldexp(static_cast<double>(n), -4); };
  std::array<std::int64_t, 3> x, off;
  for (auto& place : x) place = d.integer(0, kSteps);
  for (auto& place : off) place = d.integer(-2, 2);
  const std::int64_t radius = d.integer(1, 4);
  const double scale = std::ldexp(1.0, d.integer(-20, 20));
  Case about;
  auto& [triangle, point] = about.query.patches;
  triangle = {Shape::triangle(1), {{0, 0, 0}, {0, scale, 0}, {scale, 0, 0}}, {}};
  triangle.velocities.resize(3, Vec3<double>(0, 0, 0));
  point = {
      Shape::point(),
      {{scale * steps(x[0] + off[0]), scale * steps(x[1] + off[1]), scale * steps(x[2] + off[2])}},
      {{0, 0, -scale}}};
  ContactBox& box = about.truth.contact_box.emplace();
  box.centre = {steps(x[0]), steps(x[1]), 0, 0, steps(x[2])};
  box.varied = {0, 1, ContactBox::kTime};
  box.radius.fill(steps(radius));
  for (std::size_t i = 0; i < 3; ++i) box.inverse[i][i] = 1 / scale;
  const std::uint64_t without = d.choose(7);  // a row of the matrix, or none
  if (without < 3) box.inverse[without] = {0, 0, 0};
  const bool inside = x[0] >= radius && x[1] >= radius &&
                      x[0] + x[1] + 2 * radius <= std::int64_t{kSteps} && x[2] >= radius;
  const bool near = std::ranges::all_of(off, [&](auto o) { return std::abs(o) <= radius; });
  const bool regular = without >= 3;
  show(d, "case", about);
  CLAIM(check_box(about.query, box).has_value() == (inside && near && regular));
}

}  // namespace

std::vector<Property> certificates_claims() {
  return {
      {"checker.refuses_wrong_witnesses",
       "A witness is accepted iff the patches touch in it, also if it or they are changed",
       "src/certify/checker/check_witness.hpp",
       [](Draw& d) {
         claim_judged_by_meaning(d, supposed(draw_contact(d, {-2, 2})));
       }},
      {"checker.refuses_changed_planes",
       "A moving plane, also of round patches and at a separation, is accepted, and refused once "
       "either patch, the plane, its time or the separation was changed so that it proves nothing",
       "src/certify/checker/check_plane.hpp", check_changed_plane},
      {"checker.refuses_changed_boxes",
       "A contact box is accepted iff its centre is near enough to the contact, it lies in the "
       "domain and in t >= 0, and its matrix is regular",
       "src/certify/checker/check_box.hpp", check_contact_box},
  };
}

}  // namespace ccdfuzz
