#include "properties/linear_queries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/double_parts.hpp"
#include "case/case_json.hpp"
#include "ccd/certified/rough_contact.hpp"
#include "certify/linear/first_contact.hpp"
#include "certify/oracle/oracle.hpp"
#include "method/method.hpp"
#include "properties/draw_grazing.hpp"
#include "properties/draw_linear.hpp"

namespace ccdfuzz {

Check linear_decision_is_proven(const Query& query) {
  try {
    const Decision decision = decide(query);
    if (decision.truth.collides) return Check::holds();
    return Check::fails("undecided\n" + to_json({query, decision.truth, {}, {}}));
  } catch (const InternalError& error) {
    return Check::fails(fmt::format("{}\n{}", error.what(), to_json({query, {}, {}, {}})));
  }
}

Check no_false_negative_on_linear(const std::string& method, const Query& query,
                                  const SearchOptions& options) {
  auto contact = linear::first_contact(query);
  if (!contact) return Check::discarded("there is no contact");
  const auto solver = make_method(method);
  CCDFUZZ_VERIFY(solver);
  const Answer answer = (*solver)->answer(query, options);
  if (answer.verdict == Verdict::kUndecided) return Check::holds();
  std::string wrong;
  if (answer.verdict == Verdict::kMiss) {
    wrong = "misses a contact";
  } else {
    const Rational toi = exact(answer.toi.value());
    if (contact->time.sign_of(linear::Polynomial({-toi.get_num(), toi.get_den()})) < 0) {
      wrong = fmt::format("is late, with toi {}", to_hex(*answer.toi));
    }
  }
  if (wrong.empty()) return Check::holds();
  return Check::fails(fmt::format("{} {} at precision {}, contact in [{}, {}]\n{}", method, wrong,
                                  options.precision, to_text(contact->time.lo()),
                                  to_text(contact->time.hi()), to_json({query, {}, {}, {}})));
}

int most_places(const Query& query) {
  int most = 0;
  const DoubleParts step = parts_of(query.t_max);
  for (int k = 0; k < 3; ++k) {
    int least = std::numeric_limits<int>::max(), top = std::numeric_limits<int>::min();
    const auto note = [&](double x, int exponent, int above) {
      if (x == 0) return;
      least = std::min(least, parts_of(x).exponent + exponent);
      top = std::max(top, parts_of(x).top() + above);
    };
    for (const MovingPatch<double>& patch : query.patches) {
      for (const Vec3<double>& p : patch.positions) note(p[k], 0, 0);
      for (const Vec3<double>& v : patch.velocities) note(v[k], step.exponent, step.top());
    }
    if (least <= top) most = std::max(most, top - least);
  }
  return most;
}

Check linear_answer_is_exact(const Query& query, const SearchOptions& options) {
  const auto contact = linear::first_contact(query);
  const Answer answer = (*make_method("tdibm-c"))->answer(query, options);
  std::string wrong;
  if (answer.verdict != (contact ? Verdict::kHit : Verdict::kMiss)) {
    wrong = contact ? "misses a contact" : "finds a contact where there is none";
  } else if (contact) {
    // Enclosures of times are halved until they are narrower than a thousandth of the precision.
    const Rational toi = exact(*answer.toi), step = exact(query.t_max);
    const Rational allowed = exact(options.precision) * step;
    auto time = contact->time;
    while (time.hi() - time.lo() > allowed / 1024) time.refine();
    if (toi > time.hi()) wrong = "is late";
    if (time.lo() - toi > allowed) wrong = "is early";
  }
  if (wrong.empty()) return Check::holds();
  return Check::fails(fmt::format("tdibm-c {}, with toi {} at precision {}\n{}", wrong,
                                  answer.toi ? to_hex(*answer.toi) : "-", options.precision,
                                  to_json({query, {}, {}, {}})));
}

namespace {

/// A degenerate query, made different by as little as 2^-60 of its size, or with a coordinate of
/// another scale than the others.
Result<Query> draw_nearly_degenerate(Draw& choices) {
  Result<Query> drawn = draw_linear(choices);
  if (!drawn) return drawn;
  double size = 0;
  for (const MovingPatch<double>& patch : drawn->patches) {
    for (const Vec3<double>& p : patch.positions) size = std::max(size, p.cwiseAbs().maxCoeff());
  }
  const auto k = static_cast<int>(choices.choose(2));
  if (choices.coin()) {
    MovingPatch<double>& patch = drawn->patches[choices.choose(1)];
    const int exponent = -static_cast<int>(choices.integer(1, 60));
    const double gap = (choices.coin() ? -size : size) * std::ldexp(1, exponent);
    const bool one_corner = choices.coin();
    for (Vec3<double>& p : patch.positions) {
      p[k] += gap;
      if (one_corner) break;
    }
  }
  if (choices.coin()) {
    const int exponent = static_cast<int>(choices.integer(-60, 60));
    for (MovingPatch<double>& patch : drawn->patches) {
      for (Points<double>* points : {&patch.positions, &patch.velocities}) {
        for (Vec3<double>& p : *points) p[k] = std::ldexp(p[k], exponent);
      }
    }
  }
  return drawn;
}

Check check_linear_exact(Draw& choices) {
  const Result<Query> drawn =
      choices.choose(2) == 2 ? draw_grazing(choices) : draw_nearly_degenerate(choices);
  if (!drawn) return Check::discarded(drawn.error().message());
  if (most_places(*drawn) > 254) return Check::discarded("numbers of too many binary places");
  const SearchOptions options{.precision = choices.pick(std::array{1e-4, 1e-1, 1e-12})};
  return linear_answer_is_exact(*drawn, options);
}

/// All bits of a number in [-1, 1].
double full_bits(Draw& choices) {
  constexpr std::int64_t kMost = std::int64_t{1} << 53;
  return std::ldexp(static_cast<double>(choices.integer(-kMost, kMost)), -53);
}

/// Two edges, or a point and a face, that touch about t = ½ or nearly do, often with a corner or a
/// point of an edge.
Query draw_about_touching(Draw& choices) {
  const auto vector = [&] {
    const double x = full_bits(choices), y = full_bits(choices);
    return Vec3<double>{x, y, full_bits(choices)};
  };
  const bool edges = choices.coin();
  Query query;
  std::array<Vec3<double>, 2> at;
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    patch.shape = edges ? Shape::curve(1) : s == 0 ? Shape::point() : Shape::triangle(1);
    at[s] = {0, 0, 0};
    double left = 1;
    for (int i = patch.shape.control_count() - 1; i >= 0; --i) {
      const Vec3<double> p = vector(), v = vector();
      const double share =
          i == 0 ? left : choices.pick(std::array{0.0, 1.0, 0.5, 0.25, 0.375, 0.6875}) * left;
      left -= share;
      at[s] += share * (p + 0.5 * v);
      patch.positions.insert(patch.positions.begin(), p);
      patch.velocities.insert(patch.velocities.begin(), v);
    }
  }
  const double apart = choices.pick(std::array{0.0, 0.0, 0x1p-40, 0x1p-10});
  const Vec3<double> gap = apart * vector();
  for (Vec3<double>& p : query.patches[0].positions) p += at[1] - at[0] + gap;
  return query;
}

/// Also where the window ends or begins at the contact, as near as doubles are, and where corners
/// pass each other, which are as often inside as outside.
Check check_doubles_decide(Draw& choices) {
  using certified::RoughContact;
  Query query = draw_about_touching(choices);
  const double length = choices.pick(std::array{0x1p-50, 0x1p-40, 0x1p-13, 0.25, 0.5});
  const double from = choices.pick(std::array{0.5 - length, 0.5 - 0.5 * length, 0.5});
  query.t_max = from + length * choices.pick(std::array{1.0, 2.0});
  const double width = choices.pick(std::array{0x1p-44, 0x1p-40, 0x1p-20, 1.0});
  const double first = choices.pick(std::array{0.0, from + width});
  certified::NormalisedQuery normalised;
  certified::normalise(query, normalised);
  const auto normal = [&](double t) { return std::ldexp(t, -normalised.time); };
  const RoughContact rough =
      certified::rough_contact(normalised, normal(from), normal(first), normal(width));
  if (rough.kind == RoughContact::Kind::kOpen) return Check::discarded("doubles do not decide");

  // What begins at `from`, exactly.
  auto patches = linear::exact_patches(query);
  for (MovingPatch<Rational>& patch : patches) patch.positions = patch.at(exact(from));
  auto contact = linear::first_contact(patches, exact(query.t_max) - exact(from));
  const auto is_at_least = [&](const Rational& t) {
    return contact->time.sign_of(linear::Polynomial({-t.get_num(), t.get_den()})) >= 0;
  };
  std::string wrong;
  if (contact.has_value() != (rough.kind == RoughContact::Kind::kProven)) {
    wrong = contact ? "see no contact where there is one" : "see a contact where there is none";
  } else if (contact) {
    // What brings the width to normalised time and back is off by 2^-50 of it.
    const Rational lo = exact(std::ldexp(rough.time, normalised.time)) - exact(from);
    const Rational hi = lo + exact(width) * (1 + power_of_two(-50));
    if (!is_at_least(lo)) wrong = "are late";
    if (is_at_least(hi)) wrong = "are early";
  }
  if (wrong.empty()) return Check::holds();
  return Check::fails(fmt::format("doubles {}: from {}, width {}, time {}\n{}", wrong, to_hex(from),
                                  to_hex(width), to_hex(rough.time), to_json({query, {}, {}, {}})));
}

Check check_linear_decision(Draw& choices) {
  const Result<Query> drawn = draw_linear(choices);
  return drawn ? linear_decision_is_proven(*drawn) : Check::discarded(drawn.error().message());
}

Check check_linear_answer(const std::string& method, Draw& choices, const SearchOptions& options) {
  const Result<Query> drawn = draw_linear(choices);
  return drawn ? no_false_negative_on_linear(method, *drawn, options)
               : Check::discarded(drawn.error().message());
}

}  // namespace

std::vector<Property> linear_properties() {
  constexpr auto kHolds = Expectation::kHolds;
  constexpr const char* kClaim =
      "No contact of a degenerate linear query is missed, and none reported late";
  return {
      {"linear.decision_is_proven",
       "Degenerate linear queries are decided, and the independent checker accepts the decision",
       "src/certify/checker/check_linear.hpp", kHolds, check_linear_decision},
      {"tdibm-rational.no_false_negative_linear", kClaim, "exact arithmetic", kHolds,
       [](Draw& c) {
         constexpr SearchOptions kCoarse = {0x1p-6, 300, SearchOptions().max_bytes};
         return check_linear_answer("tdibm-rational", c, kCoarse);
       }},
      {"tdibm-c.no_false_negative_linear", kClaim, "src/ccd/certified/DERIVATION.md", kHolds,
       [](Draw& c) {
         constexpr SearchOptions kFine = {1e-4, 2000, SearchOptions().max_bytes};
         return check_linear_answer("tdibm-c", c, kFine);
       }},
      {"tdibm-c.linear_decided_exactly",
       "Degenerate linear queries, near ones and ones that graze are decided exactly, at a time "
       "within the precision",
       "src/ccd/certified/DERIVATION.md", kHolds, check_linear_exact},
      {"tdibm-c.doubles_decide_exactly",
       "Where doubles decide a linear query, exact arithmetic finds the same, at such a time",
       "src/ccd/certified/DERIVATION.md", kHolds, check_doubles_decide},
  };
}

}  // namespace ccdfuzz
