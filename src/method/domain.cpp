#include "method/domain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "case/body_motion.hpp"
#include "case/mesh.hpp"
#include "case/scale.hpp"
#include "certify/oracle/oracle.hpp"
#include "method/setting.hpp"

namespace ccdfuzz {

namespace {

using Pair = Domain::Pair;

bool fits(const Shape& shape, const Domain::Side& side) {
  return shape.kind == side.shape &&
         std::cmp_less_equal(std::max(shape.n, shape.m), side.max_degree);
}

bool are_of_same_shapes(const Pair& a, const Pair& b) {
  return a[0].shape == b[0].shape && a[1].shape == b[1].shape;
}

/// Whether convex bodies that then move touch or overlap at 0.
bool overlaps_at_start(const Case& value) {
  return is_of_bodies(value.query) && !has_mesh(value.query) && value.query.t_max > 0 &&
         value.truth.contact_by() == Rational(0);
}

/// The radians by which a body spins in a unit of time.
double spun(const BodyTurn& turn) {
  return turn.is_spin() ? std::hypot(turn.spin[0], turn.spin[1], turn.spin[2]) : 0;
}

std::string spins_text(double most) {
  return fmt::format("spins by {} at most", most == kSmallSpin ? "π/4" : "3 radians");
}

/// The smaller of two limits; none is no limit.
template <class T>
std::optional<T> least(const std::optional<T>& a, const std::optional<T>& b) {
  return a && b ? std::min(a, b) : a ? a : b;
}

/// The kinds of bodies that are of both lists.
BodyKinds common(const BodyKinds& some, const BodyKinds& others) {
  if (some.empty() || others.empty()) return some.empty() ? others : some;
  BodyKinds both;
  for (const BodyKind& a : some) {
    for (const BodyKind& b : others) {
      const BodyKind kind{std::max(a.least_points, b.least_points),
                          std::min(a.most_points, b.most_points),
                          a.radius == RadiusRule::kAny ? b.radius : a.radius};
      const bool agree = b.radius == RadiusRule::kAny || b.radius == kind.radius;
      if (agree && kind.least_points <= kind.most_points) both.push_back(kind);
    }
  }
  return both;
}

/// Whether all numbers are within the scale, but for a separation, which may be smaller: it is no
/// size of what simulations hold, but a gap.
bool is_of_scale(const Query& query, int scale) {
  if (query.separation == 0 || query.separation > 1) return is_within_scale(query, scale);
  Query touching = query;
  touching.separation = 0;
  return is_within_scale(touching, scale);
}

/// "1 point (radius > 0)", "4 to 8 points (radius 0)", "4 or more points".
std::string points_text(const BodyKind& kind) {
  std::string text = fmt::format("{}", kind.least_points);
  if (kind.most_points >= kMaxControls) {
    text += " or more";
  } else if (kind.most_points > kind.least_points) {
    text += fmt::format(" to {}", kind.most_points);
  }
  constexpr std::array kRadii = {"", " (radius 0)", " (radius > 0)"};
  return text + (kind.most_points == 1 ? " point" : " points") +
         kRadii[static_cast<size_t>(kind.radius)];
}

}  // namespace

bool stays_within(const Query& query, int scale) {
  const bool are_bodies = is_of_bodies(query);
  const double farthest = are_bodies ? largest_motion(query) : largest_coordinate_at_ends(query);
  return farthest <= std::ldexp(1.0, scale);
}

std::optional<bool> Domain::order_of(const Query& query) const {
  if (pairs.empty()) return false;
  for (const bool is_swapped : {false, true}) {
    for (const Pair& pair : pairs) {
      const Shape& first = query.patches[is_swapped ? 1 : 0].shape;
      const Shape& second = query.patches[is_swapped ? 0 : 1].shape;
      if (fits(first, pair[0]) && fits(second, pair[1])) return is_swapped;
    }
  }
  return std::nullopt;
}

std::string Domain::broken_by(const Query& query) const {
  const bool are_bodies = is_of_bodies(query);
  const auto is_of_kinds = [&](const MovingPatch<double>& body) {
    return !body.faces.empty() || is_one_of(body_kinds, body.positions.size(), body.radius > 0);
  };
  if (are_bodies && !std::ranges::all_of(query.patches, is_of_kinds)) {
    return "has no shape for one of these bodies";
  }
  if (binary32 && !is_binary32(query)) return "takes floats, and a number of this is none";
  if (binary32 && are_bodies && !are_given_as_floats(query)) {
    return "takes floats, and a motion of these bodies or a capsule's middle is none";
  }
  if (scale && !is_of_scale(query, *scale)) {
    return fmt::format("takes numbers that are 0 or within 2^±{}", *scale);
  }
  if (scale && !stays_within(query, *scale)) {
    return are_bodies
               ? fmt::format("takes bodies that move by 2^{} at most", *scale)
               : fmt::format("takes patches whose points are within 2^{} at t_max, too", *scale);
  }
  if (most_spin && std::ranges::any_of(query.patches, [&](const MovingPatch<double>& body) {
        return body.turn && spun(*body.turn) * query.t_max > *most_spin;
      })) {
    return fmt::format("takes {} in the step", spins_text(*most_spin));
  }
  return plane && are_bodies && !is_in_plane(query) ? "takes bodies in the plane z = 0" : "";
}

std::string Domain::broken_by(const Case& value) const {
  if (std::string why = broken_by(value.query); !why.empty() || !ordinary) return why;
  if (value.truth == Truth() && is_decided_exactly(value.query)) {
    // What is ordinary rests on when and how patches touch.
    const Case decided{value.query, decide(value.query).truth, {}, {}};
    if (decided.truth != Truth()) return broken_by(decided);
  }
  if (!plane && has_flat_body(value.query)) {
    return "takes bodies of four points or more that have a volume";
  }
  const Setting setting = setting_of(value);
  if (initial_overlap && setting == Setting::kAtAnEnd && overlaps_at_start(value)) return "";
  if (setting != Setting::kOrdinary) {
    return fmt::format("takes ordinary queries, and this is {}", name_of(setting));
  }
  return is_shallow(value) ? "takes contacts of some depth, and this is shallow" : "";
}

std::optional<Domain> Domain::with(const Domain& other) const {
  Domain both{{},
              common(body_kinds, other.body_kinds),
              least(scale, other.scale),
              binary32 || other.binary32,
              ordinary || other.ordinary,
              (initial_overlap || !ordinary) && (other.initial_overlap || !other.ordinary),
              plane || other.plane,
              least(most_spin, other.most_spin)};
  for (const Pair& a : pairs) {
    if (other.pairs.empty()) both.pairs.push_back(a);
    for (const Pair& given : other.pairs) {
      const Pair b = are_of_same_shapes(a, given) ? given : Pair{given[1], given[0]};
      if (!are_of_same_shapes(a, b)) continue;
      Pair& least = both.pairs.emplace_back(a);
      for (size_t s = 0; s < 2; ++s) {
        least[s].max_degree = std::min(a[s].max_degree, b[s].max_degree);
      }
    }
  }
  if (pairs.empty()) both.pairs = other.pairs;
  const bool have_pairs = !both.pairs.empty() || (pairs.empty() && other.pairs.empty());
  const bool have_bodies =
      !both.body_kinds.empty() || (body_kinds.empty() && other.body_kinds.empty());
  return have_pairs && have_bodies ? std::optional(both) : std::nullopt;
}

std::vector<std::string> Domain::pair_texts() const {
  const auto shown = [](const Side& side) {
    return side.max_degree == 0 ? std::string(name_of(side.shape))
                                : fmt::format("{}({})", name_of(side.shape), side.max_degree);
  };
  std::vector<std::string> texts;
  for (const auto& [a, b] : pairs) texts.push_back(shown(a) + " and " + shown(b));
  return texts;
}

std::string Domain::text() const {
  std::vector<std::string> rules;
  if (binary32) rules.emplace_back("floats");
  if (scale) rules.push_back(fmt::format("within 2^±{}", *scale));
  if (plane) rules.emplace_back("bodies in the plane z = 0");
  if (!body_kinds.empty()) {
    std::vector<std::string> kinds;
    for (const BodyKind& kind : body_kinds) kinds.push_back(points_text(kind));
    rules.push_back(fmt::format("bodies of {}", fmt::join(kinds, " or ")));
  }
  if (most_spin) rules.push_back(spins_text(*most_spin));
  if (ordinary) rules.emplace_back("ordinary queries alone");
  if (ordinary && initial_overlap) rules.emplace_back("or bodies that overlap at 0");
  return fmt::format("{}", fmt::join(rules, ", "));
}

}  // namespace ccdfuzz
