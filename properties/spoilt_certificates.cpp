#include <cmath>

#include "certify/checker/check_box.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/miss_tree.hpp"
#include "certify/oracle/oracle.hpp"
#include "files/case_json.hpp"
#include "generators/draw_contact.hpp"
#include "generators/round.hpp"
#include "properties/case_file.hpp"
#include "properties/draw_trimmed.hpp"
#include "properties/draw_weighted.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// A contact of plain, rational or trimmed patches that is known, and what the oracle says of the
/// time before it. Or one at a separation, and the plane that it is planted with.
Case draw_proven_contact(Draw& choices) {
  Case known;
  switch (choices.choose(3)) {
    case 0:
      known = supposed(draw_contact(choices, {-2, 2, 2}));
      break;
    case 1:
      known = case_of(draw_weighted_contact(choices));
      break;
    case 2:
      return draw_round_case(ContactClass::kVF, true, choices);
    default:
      known = draw_trimmed_contact(choices);
  }
  const OracleOptions little{.max_pops = 60, .max_tree_nodes = 800, .known = known.truth.witness};
  known.truth = decide(known.query, little).truth;
  return known;
}

/// A number that is another, nearly another, or any.
Rational draw_number(Draw& choices, const Rational& model) {
  switch (choices.choose(3)) {
    case 0:
      return model;
    case 1:
      return -model;
    case 2:
      return model + choices.dyadic(8, choices.integer(-60, 2)).rational();
    default:
      return exact(choices.finite_double());
  }
}

/// `contact` or later.
Rational draw_late(Draw& choices, const Rational& contact) {
  if (choices.coin()) return contact;
  return contact + abs(choices.dyadic(8, choices.integer(-60, 2))).rational();
}

/// A tree that is another with some of its bytes changed, or says that a whole patch is outside of
/// its trim, or any bytes.
std::string draw_tree(Draw& choices, const std::string& model, bool is_trimmed) {
  constexpr std::size_t kLongest = 400;
  if (is_trimmed && choices.coin()) {
    TreeBits bits;
    bits.outside(choices.coin() ? 1 : 0);
    return bits.bytes();
  }
  if (model.empty() || choices.choose(3) == 0) return choices.text(kLongest);
  std::string tree = model;
  for (std::uint64_t left = choices.choose(3); left > 0; --left) {
    const std::size_t at = choices.choose(tree.size() - 1);
    tree[at] = static_cast<char>(choices.choose(255));
  }
  return choices.coin() ? tree : tree + choices.text(8);
}

void claim_tree_refused(Draw& d, const Case& known) {
  const auto* const own = clearance_of<MissTree>(known.truth);
  const std::string model = own == nullptr ? "" : own->tree.bytes;
  const Rational until = show(d, "until", draw_late(d, *known.truth.contact_by()));
  const std::string tree = draw_tree(d, model, is_trimmed(known.query));
  show(d, "tree", AsHex{tree});
  CLAIM(!check_tree(known.query, until, tree));
}

void claim_plane_refused(Draw& d, const Case& known) {
  const Truth& truth = known.truth;
  MovingPlane plane{0, {1, 0, 0}, 0};
  if (const auto* model = clearance_of<MovingPlane>(truth)) plane = *model;
  for (Rational& x : plane.normal) x = draw_number(d, x);
  plane.offset = draw_number(d, plane.offset);
  plane.until = draw_late(d, *truth.contact_by());
  // At the contact itself the plane is right: it proves the time before.
  if (plane.until == *truth.contact_by()) plane.until += power_of_two(-40);
  show(d, "until", plane.until);
  show(d, "normal", plane.normal);
  show(d, "offset", plane.offset);
  CLAIM(!check_plane(known.query, plane));
}

double draw_double_like(Draw& choices, double model) {
  switch (choices.choose(3)) {
    case 0:
      return model;
    case 1:
      return choices.nudged(model, 8);
    case 2:
      return std::ldexp(model, choices.integer(-30, 30));
    default:
      return choices.finite_double();
  }
}

/// A box is refused if it holds a contact at a time that is proven to be clear.
void claim_box_refused(Draw& d, Case known) {
  const Truth& truth = known.truth;
  if (!truth.clearance || !truth.witness) return;
  ContactBox box = truth.contact_box.value_or(ContactBox{});
  if (!truth.contact_box) {
    for (std::size_t s = 0; s < 2; ++s) {
      for (std::size_t k = 0; k < 2; ++k) {
        box.centre[2 * s + k] = round_down(truth.witness->uv[s][k]);
      }
    }
    box.centre[ContactBox::kTime] = round_down(truth.witness->t);
    box.varied = {0, 1, ContactBox::kTime};
    box.radius = {0.125, 0.125, 0.125};
    for (std::size_t i = 0; i < 3; ++i) box.inverse[i][i] = 1;
  }
  const auto place = static_cast<int>(d.choose(4));
  if (d.coin()) box.varied = {place, (place + 1) % 5, ContactBox::kTime};
  for (double& x : box.centre) x = draw_double_like(d, x);
  for (double& x : box.radius) x = draw_double_like(d, x);
  for (auto& row : box.inverse) {
    for (double& x : row) x = draw_double_like(d, x);
  }
  known.truth.contact_box = box;
  show(d, "with a box", known);
  CLAIM(!check_box(known.query, box) || !covers(*truth.clearance, box.until()));
}

/// At one with each other are a contact and a clearance that does not cover it.
void claim_texts_agree(Draw& d, const Case& known) {
  const std::string text = show(d, "text", draw_spoilt_text(d, to_json(known)));
  const Result<Case> read = parse_case(text, "input");
  if (!read || !check_truth(*read)) return;
  const Truth& truth = read->truth;
  if (!truth.clearance || !check_clearance(read->query, *truth.clearance)) return;
  const auto contact = truth.contact_by();
  CLAIM(!contact || !covers(*truth.clearance, *contact));
}

void check_wrong_certificates(Draw& d) {
  const Case known = draw_proven_contact(d);
  show(d, "contact", known);
  claim_plane_refused(d, known);
  claim_box_refused(d, known);
  claim_texts_agree(d, known);
  claim_tree_refused(d, known);  // last, as nothing is drawn after a text
}

}  // namespace

std::vector<Property> spoilt_certificates_claims() {
  return {{"checker.refuses_wrong_certificates",
           "No tree or plane covers the time of a contact, no box holds one at a time that is "
           "proven to be clear, and what texts that are almost case files prove agrees",
           "src/case/certificate.hpp", check_wrong_certificates}};
}

}  // namespace ccdfuzz
