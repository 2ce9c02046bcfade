#include <array>
#include <cmath>

#include "certify/checker/check_case.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/linear/first_contact.hpp"
#include "certify/oracle/oracle.hpp"
#include "files/case_json.hpp"
#include "generators/draw_patch.hpp"
#include "properties/draw_linear.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Touching, or at a separation.
Query draw_linear_query(Draw& d) {
  return d.coin() ? draw_linear_apart(d) : supposed(draw_linear(d));
}

/// A clearance that ends before, at or after the first contact, or before t = 0. If after, at a
/// time of which the contact's is a number of eighths, which halving reaches: else the checker
/// refuses, too, but only after 4,000 halvings.
void check_clearance_of_linear(Draw& d) {
  Case asked;
  asked.query = draw_linear_query(d);
  auto contact = linear::first_contact(asked.query);
  LinearClearance clearance{exact(asked.query.t_max), d.coin()};
  if (contact) {
    contact->narrow(power_of_two(-64));
    clearance.until = contact->lo();
  }
  const bool known = !contact || contact->is_rational();
  const int eighths = d.integer(0, 16);
  if (eighths == 0) {
    clearance.until = -power_of_two(-64);
  } else if (contact && (known || eighths > 8)) {
    clearance.until *= Rational(8) / static_cast<long>(eighths);
  }

  const Rational& until = clearance.until;
  bool clear = until >= 0;
  if (clear && contact) {
    const int after = contact->sign_of(linear::Polynomial({-until.get_num(), until.get_den()}));
    clear = clearance.closed ? after > 0 : after >= 0;
  }
  asked.truth.clearance = clearance;
  show(d, "clear", clear);
  show(d, "case", asked);
  CLAIM(check_linear_clearance(asked.query, clearance).has_value() == clear);
}

/// Patch 1 along an edge of either patch as it is at t, which leaves coplanar what is. Discarded if
/// that asks for numbers that no double holds.
void move_along_an_edge(Draw& choices, Query& query, const Rational& t) {
  const auto corners = linear::exact_patches(query)[choices.choose(1)].at(t);
  suppose(corners.size() >= 2);
  const std::size_t from = choices.choose(corners.size() - 2);
  const int times = choices.integer(-3, 3);
  for (int k = 0; k < 3; ++k) {
    const Rational step = times * (corners[from + 1][k] - corners[from][k]);
    for (Vec3<double>& p : query.patches[0].positions) {
      p[k] = supposed(to_double_exactly(exact(p[k]) + step));
    }
  }
}

bool meet_within(const Query& query, const Rational& from, const Rational& by) {
  auto patches = linear::exact_patches(query);
  for (MovingPatch<Rational>& patch : patches) patch.positions = patch.at(from);
  return linear::first_contact(patches, by - from, exact(query.separation)).has_value();
}

/// What an accepted root must be: a contact at it, if it is rational by its polynomial, or else in
/// its interval.
bool is_contact(const Query& query, const ContactRoot& root) {
  if (root.from < 0) return false;
  if (root.polynomial.size() != 2) return meet_within(query, root.from, root.by);
  const Rational t = Rational(-root.polynomial[0]) / root.polynomial[1];
  return root.from < t && t < root.by && meet_within(query, t, t);
}

/// The linear polynomial with this root.
std::vector<Integer> with_root(const Rational& t) {
  return {-t.get_num(), t.get_den()};
}

enum class RootChange : std::uint8_t { kNone, kElsewhere, kMoved, kOtherTime, kEarlier, kNearer };

/// One thing of a contact's certificate changed, be it the query.
void change_root(Draw& choices, RootChange change, Query& query, ContactRoot& root) {
  const Rational middle = (root.from + root.by) / 2;
  const Rational share = Rational(choices.integer(1, 7)) / 8;
  switch (change) {
    case RootChange::kNone:
      break;
    case RootChange::kElsewhere:
      move_along_an_edge(choices, query, middle);
      break;
    case RootChange::kMoved: {
      const auto axis = static_cast<int>(choices.choose(2));
      const double by = std::ldexp(1.0, choices.integer(-16, 2));
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
    case RootChange::kNearer:
      query.separation *= 1 - std::ldexp(1.0, -choices.integer(1, 53));
      break;
  }
}

/// The root of the first contact, as it is or with one thing changed. What is accepted must be a
/// contact; what is one is accepted on a short enough interval (check_linear.hpp).
void check_root_of_linear(Draw& d) {
  Case asked;
  Query& query = asked.query;
  query = draw_linear_query(d);
  linear::RealRoot time = supposed(linear::first_contact(query));
  const auto change = static_cast<RootChange>(d.choose(5));
  ContactRoot& root = asked.truth.contact_root.emplace();
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
    if (check_contact_root(query, root)) return;
  }
  show(d, "case", asked);
  const bool is_refused = change == RootChange::kNone && root.from >= 0;
  CLAIM(!is_refused);
  change_root(d, change, query, root);
  show(d, "changed", asked);
  CLAIM(!check_contact_root(query, root) || is_contact(query, root));
}

/// Linear patches, often degenerate, whose numbers differ by up to 2^1022: each axis, velocities,
/// the separation and a few numbers have a magnitude of their own. Discarded if a number is past
/// the doubles.
Query draw_spread(Draw& d) {
  const int most = d.pick(std::array{60, 60, 300, 600, 1022});
  const auto power = [&] { return d.coin() ? 0 : d.integer(-most, most); };
  Query query = supposed(draw_linear(d));
  const int time = power();
  query.t_max = std::ldexp(query.t_max, -time);
  query.separation = d.coin() ? 0 : std::ldexp(1 + d.integer(0, 7), power());
  for (int k = 0; k < 3; ++k) {
    const int axis = power();
    for (MovingPatch<double>& patch : query.patches) {
      for (Vec3<double>& p : patch.positions) p[k] = std::ldexp(p[k], axis);
      for (Vec3<double>& v : patch.velocities) v[k] = std::ldexp(v[k], axis + time);
    }
  }
  for (int moved = d.integer(0, 2); moved > 0; --moved) {
    MovingPatch<double>& patch = query.patches[d.choose(1)];
    Points<double>& points = d.coin() ? patch.positions : patch.velocities;
    Vec3<double>& p = points[d.choose(points.size() - 1)];
    p[static_cast<int>(d.choose(2))] += std::ldexp(d.integer(-3, 3), power());
  }
  suppose(is_valid(query));
  return query;
}

/// What the oracle says is written and read again, and accepted.
void check_decision_is_read(Draw& d) {
  Case made;
  made.query = show(d, "query", draw_spread(d));
  const Decision decision = decide(made.query, {.max_pops = 300, .max_tree_nodes = 500});
  show(d, "note", decision.note);
  made.truth = decision.truth;
  const Result<Case> read = show(d, "read", parse_case(to_json(made), "file"));
  CLAIM(read.has_value());
  CLAIM(*read == made);
  CLAIM(check_case(*read).has_value());
}

/// A clock that has gone on by one second each time that it is read.
thread_local double seconds_read = 0;
double reading_clock() {
  return ++seconds_read;
}

/// With a limit of time the oracle says the same, or less. Finding and checking what was found end
/// at the first look at the clock after their time, and so does checking a part of it.
void check_time_is_kept(Draw& d) {
  const Query query = show(d, "query", draw_spread(d));
  const OracleOptions few = {.max_pops = 300, .max_tree_nodes = 500};
  const Truth free = decide(query, few).truth;
  OracleOptions limited = few;
  limited.max_seconds = show(d, "seconds", d.integer(0, 300));
  limited.clock = reading_clock;
  seconds_read = 0;
  const Truth truth = decide(query, limited).truth;
  show(d, "case", Case{query, truth, {}, {}});
  CLAIM(!truth.collides || truth.collides == free.collides);
  constexpr int kParts = 3, kLooks = 3;
  CLAIM(show(d, "looks", seconds_read) <= kParts * (limited.max_seconds + kLooks));
}

}  // namespace

std::vector<Property> linear_certificates_claims() {
  constexpr auto kSource = "src/certify/checker/check_linear.hpp";
  return {
      {"checker.refuses_wrong_linear_clearances",
       "A linear clearance, also at a separation, is accepted iff it ends before the first "
       "contact, or with it and open",
       kSource, check_clearance_of_linear},
      {"checker.refuses_wrong_roots",
       "The root of a contact, also at a separation, is accepted, and after a change only if it is "
       "one still",
       kSource, check_root_of_linear},
      {"oracle.is_read",
       "What the oracle says of linear patches of all magnitudes is written, read again and "
       "accepted",
       "src/certify/oracle/is_readable.hpp", check_decision_is_read},
      {"oracle.keeps_time",
       "With a limit of time the oracle says the same of linear patches, or less, and in time",
       "src/certify/oracle/oracle.hpp", check_time_is_kept},
  };
}

}  // namespace ccdfuzz
