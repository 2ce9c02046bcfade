#include <fmt/format.h>

#include <cmath>

#include "case/case_json.hpp"
#include "certify/checker/check_box.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/draw_contact.hpp"
#include "properties/case_file.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

/// A contact that is known, and what the oracle says of the time before it.
struct ProvenContact {
  Case known;
  std::string tree;
};

Result<ProvenContact> draw_proven_contact(Draw& choices) {
  Result<Case> drawn = draw_contact(choices, {-2, 2, 2});
  if (!drawn) return tl::unexpected(drawn.error());
  OracleOptions little;
  little.max_pops = 60;
  little.max_tree_nodes = 800;
  little.known = drawn->truth.witness;
  Decision decision = decide(drawn->query, little);
  ProvenContact out{*std::move(drawn), std::move(decision.tree)};
  out.known.truth = std::move(decision.truth);
  return out;
}

/// A number that is another, nearly another, or any.
Rational draw_number(Draw& choices, const Rational& model) {
  switch (choices.choose(3)) {
    case 0:
      return model;
    case 1:
      return -model;
    case 2:
      return model + choices.dyadic(8, static_cast<long>(choices.integer(-60, 2))).rational();
    default:
      return exact(choices.finite_double());
  }
}

/// `contact` or later.
Rational draw_late(Draw& choices, const Rational& contact) {
  if (choices.coin()) return contact;
  return contact + abs(choices.dyadic(8, static_cast<long>(choices.integer(-60, 2)))).rational();
}

/// A tree that is another with some of its bytes changed, or any bytes.
std::string draw_tree(Draw& choices, const std::string& model) {
  constexpr std::size_t kLongest = 400;
  if (model.empty() || choices.choose(3) == 0) return choices.text(kLongest);
  std::string tree = model;
  for (std::uint64_t left = choices.choose(3); left > 0; --left) {
    const std::size_t at = choices.choose(tree.size() - 1);
    tree[at] = static_cast<char>(choices.choose(255));
  }
  return choices.coin() ? tree : tree + choices.text(8);
}

/// No tree covers the time of a contact.
Check check_wrong_tree(Draw& choices) {
  const auto drawn = draw_proven_contact(choices);
  if (!drawn) return Check::discarded(drawn.error().message());
  const Rational until = draw_late(choices, *drawn->known.truth.contact_by());
  const std::string tree = draw_tree(choices, drawn->tree);
  if (!check_tree(drawn->known.query, until, tree)) return Check::holds();
  return Check::fails(fmt::format("clear until {} by the tree {}, but\n{}", to_text(until),
                                  to_hex_bytes(tree), to_json(drawn->known)));
}

/// No plane separates up to after a contact.
Check check_wrong_plane(Draw& choices) {
  const auto drawn = draw_proven_contact(choices);
  if (!drawn) return Check::discarded(drawn.error().message());
  const Truth& truth = drawn->known.truth;
  MovingPlane plane{0, {1, 0, 0}, 0};
  if (truth.clearance) {
    if (const auto* model = std::get_if<MovingPlane>(&*truth.clearance)) plane = *model;
  }
  for (Rational& x : plane.normal) x = draw_number(choices, x);
  plane.offset = draw_number(choices, plane.offset);
  plane.until = draw_late(choices, *truth.contact_by());
  // At the contact itself the plane may stand: it proves what comes before.
  if (plane.until == *truth.contact_by()) plane.until += power_of_two(-40);
  if (!check_plane(drawn->known.query, plane)) return Check::holds();
  return Check::fails(fmt::format("clear before {} by the plane ({}, {}, {}), {}, but\n{}",
                                  to_text(plane.until), to_text(plane.normal[0]),
                                  to_text(plane.normal[1]), to_text(plane.normal[2]),
                                  to_text(plane.offset), to_json(drawn->known)));
}

double draw_double_like(Draw& choices, double model) {
  switch (choices.choose(3)) {
    case 0:
      return model;
    case 1:
      return choices.nudged(model, 8);
    case 2:
      return std::ldexp(model, static_cast<int>(choices.integer(-30, 30)));
    default:
      return choices.finite_double();
  }
}

/// No box holds a contact at a time that is proven to be clear.
Check check_wrong_box(Draw& choices) {
  const auto drawn = draw_proven_contact(choices);
  if (!drawn) return Check::discarded(drawn.error().message());
  const Truth& truth = drawn->known.truth;
  if (!truth.clearance || !truth.witness) return Check::discarded("nothing is proven to be clear");
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
  const auto place = static_cast<int>(choices.choose(4));
  if (choices.coin()) box.varied = {place, (place + 1) % 5, ContactBox::kTime};
  for (double& x : box.centre) x = draw_double_like(choices, x);
  for (double& x : box.radius) x = draw_double_like(choices, x);
  for (auto& row : box.inverse) {
    for (double& x : row) x = draw_double_like(choices, x);
  }
  if (!check_box(drawn->known.query, box)) return Check::holds();
  if (!covers(*truth.clearance, box.until())) return Check::holds();
  Case both = drawn->known;
  both.truth.contact_box = box;
  return Check::fails("both are accepted, a contact and its absence\n" + to_json(both));
}

/// Certificates in texts that are almost case files: read, checked, and where all is accepted, at
/// one with each other.
Check check_wrong_texts(Draw& choices) {
  const auto drawn = draw_proven_contact(choices);
  if (!drawn) return Check::discarded(drawn.error().message());
  const std::string text = draw_spoilt_text(choices, to_json(drawn->known));
  const Result<Case> read = parse_case(text, "input");
  if (!read || !check_truth(*read)) return Check::holds();
  const Truth& truth = read->truth;
  if (!truth.clearance || !check_clearance(read->query, *truth.clearance, drawn->tree)) {
    return Check::holds();
  }
  const auto contact = truth.contact_by();
  if (!contact || !covers(*truth.clearance, *contact)) return Check::holds();
  return Check::fails("both are accepted, a contact and its absence\n" + text);
}

}  // namespace

std::vector<Property> spoilt_certificates_claims() {
  constexpr auto kHolds = Expectation::kHolds;
  constexpr auto kSource = "src/case/certificate.hpp";
  return {
      {"checker.refuses_wrong_trees", "No tree of separating axes covers the time of a contact",
       kSource, kHolds, check_wrong_tree},
      {"checker.refuses_wrong_planes", "No moving plane separates up to after a contact", kSource,
       kHolds, check_wrong_plane},
      {"checker.refuses_wrong_boxes", "No box holds a contact at a time that is proven to be clear",
       kSource, kHolds, check_wrong_box},
      {"checker.refuses_wrong_texts",
       "Certificates in texts that are almost case files are refused, or agree with each other",
       kSource, kHolds, check_wrong_texts},
  };
}

}  // namespace ccdfuzz
