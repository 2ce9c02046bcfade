#include <fmt/format.h>

#include <cmath>

#include "case/case_json.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/linear/first_contact.hpp"
#include "properties/draw_linear.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

Check refuted(const char* what, const Query& query, const Truth& certificate) {
  return Check::fails(fmt::format("{}\n{}", what, to_json({query, certificate, {}, {}})));
}

/// A clearance that ends before, at or after the first contact, or before t = 0. If after, at a
/// time of which the contact's is so many eighths, where halving comes to it: else the checker
/// refuses, too, but only after 4,000 halvings.
Check check_clearance_of_linear(Draw& choices) {
  const Result<Query> query = draw_linear(choices);
  if (!query) return Check::discarded(query.error().message());
  auto contact = linear::first_contact(*query);
  LinearClearance clearance{exact(query->t_max), choices.coin()};
  if (contact) {
    contact->time.narrow(power_of_two(-64));
    clearance.until = contact->time.lo();
  }
  const bool known = !contact || contact->time.is_rational();
  const auto eighths = choices.integer(0, 16);
  if (eighths == 0) {
    clearance.until = -power_of_two(-64);
  } else if (contact && (known || eighths > 8)) {
    clearance.until *= Rational(8) / static_cast<long>(eighths);
  }

  const Rational& until = clearance.until;
  bool clear = until >= 0;
  if (clear && contact) {
    const int after =
        contact->time.sign_of(linear::Polynomial({-until.get_num(), until.get_den()}));
    clear = clearance.closed ? after > 0 : after >= 0;
  }
  const bool accepted = check_linear_clearance(*query, clearance).has_value();
  if (accepted == clear) return Check::holds();
  Truth truth;
  truth.clearance = clearance;
  return refuted(accepted ? "accepts a clearance that is none" : "refuses a clearance", *query,
                 truth);
}

/// Patch 1 along an edge of either patch as it is at t, which leaves coplanar what is; nullopt if
/// that asks for numbers that no double holds.
std::optional<Query> moved_along_an_edge(Draw& choices, const Query& query, const Rational& t) {
  const auto corners = linear::exact_patches(query)[choices.choose(1)].at(t);
  if (corners.size() < 2) return std::nullopt;
  const std::size_t from = choices.choose(corners.size() - 2);
  const auto times = static_cast<long>(choices.integer(-3, 3));
  Query moved = query;
  for (int k = 0; k < 3; ++k) {
    const Rational step = times * (corners[from + 1][k] - corners[from][k]);
    for (Vec3<double>& p : moved.patches[0].positions) {
      const auto x = to_double_exactly(exact(p[k]) + step);
      if (!x) return std::nullopt;
      p[k] = *x;
    }
  }
  return moved;
}

bool touch_within(const Query& query, const Rational& from, const Rational& by) {
  auto patches = linear::exact_patches(query);
  for (MovingPatch<Rational>& patch : patches) patch.positions = patch.at(from);
  return linear::first_contact(patches, by - from).has_value();
}

/// What an accepted root must be: a contact at it, if it is rational by its polynomial, or else in
/// its interval.
bool is_contact(const Query& query, const ContactRoot& root) {
  if (root.from < 0) return false;
  if (root.polynomial.size() != 2) return touch_within(query, root.from, root.by);
  const Rational t = Rational(-root.polynomial[0]) / root.polynomial[1];
  return root.from < t && t < root.by && touch_within(query, t, t);
}

/// The linear polynomial with this root.
std::vector<Integer> with_root(const Rational& t) {
  return {-t.get_num(), t.get_den()};
}

enum class RootChange : std::uint8_t { kNone, kElsewhere, kMoved, kOtherTime, kEarlier };

/// One thing of a contact's certificate changed, be it the query. False: no double holds a number.
bool change_root(Draw& choices, RootChange change, Query& query, ContactRoot& root) {
  const Rational middle = (root.from + root.by) / 2;
  const Rational share = Rational(static_cast<long>(choices.integer(1, 7))) / 8;
  switch (change) {
    case RootChange::kNone:
      break;
    case RootChange::kElsewhere:
      if (const auto moved = moved_along_an_edge(choices, query, middle)) {
        query = *moved;
        break;
      }
      return false;
    case RootChange::kMoved: {
      const auto axis = static_cast<int>(choices.choose(2));
      const double by = std::ldexp(1.0, static_cast<int>(choices.integer(-16, 2)));
      for (Vec3<double>& p : query.patches[choices.choose(1)].positions) p[axis] += by;
      break;
    }
    case RootChange::kOtherTime:
      root.polynomial = with_root(root.from + share * (root.by - root.from));
      break;
    case RootChange::kEarlier:
      root.by = root.from;
      root.from *= share;
      if (choices.coin()) root.polynomial = with_root((root.from + root.by) / 2);
      break;
  }
  return true;
}

/// The root of the first contact, as it is or with one thing changed. What is accepted must be a
/// contact; what is one is accepted on a short enough interval (check_linear.hpp).
Check check_root_of_linear(Draw& choices) {
  const Result<Query> drawn = draw_linear(choices);
  if (!drawn) return Check::discarded(drawn.error().message());
  auto contact = linear::first_contact(*drawn);
  if (!contact) return Check::discarded("there is no contact");
  linear::RealRoot& time = contact->time;
  const auto change =
      choices.pick(std::array{RootChange::kNone, RootChange::kElsewhere, RootChange::kMoved,
                              RootChange::kOtherTime, RootChange::kEarlier});
  Query query = *drawn;
  ContactRoot root;
  // Shorter intervals than the oracle tries are not needed.
  constexpr int kMostRounds = 64;
  for (int round = 1; round <= kMostRounds; ++round) {
    const Rational width = power_of_two(-64 * round);
    time.narrow(width);
    root = {time.polynomial().coefficients(), time.lo(), time.hi()};
    if (time.is_rational()) {
      root.from -= width;
      root.by += width;
    }
    if (root.from < 0 || change != RootChange::kNone) break;
    if (check_contact_root(query, root)) return Check::holds();
  }
  Truth truth;
  truth.contact_root = root;
  if (change == RootChange::kNone && root.from >= 0) {
    return refuted("refuses the root of a contact", query, truth);
  }
  if (!change_root(choices, change, query, root)) return Check::discarded("not a double");
  truth.contact_root = root;
  if (!check_contact_root(query, root) || is_contact(query, root)) return Check::holds();
  return refuted("accepts the root of no contact", query, truth);
}

}  // namespace

std::vector<Property> linear_certificates_claims() {
  constexpr auto kHolds = Expectation::kHolds;
  return {
      {"checker.refuses_wrong_linear_clearances",
       "A linear clearance is accepted iff it ends before the first contact, or with it and open",
       "src/certify/checker/check_linear.hpp", kHolds, check_clearance_of_linear},
      {"checker.refuses_wrong_roots",
       "The root of a contact is accepted, and after a change only if it is one still",
       "src/certify/checker/check_linear.hpp", kHolds, check_root_of_linear},
  };
}

}  // namespace ccdfuzz
