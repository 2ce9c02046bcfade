#include "method/domain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "case/scale.hpp"
#include "method/setting.hpp"

namespace ccdfuzz {

namespace {

using Pair = Domain::Pair;

bool fits(const Shape& shape, ShapeKind kind, int max_degree) {
  return shape.kind == kind && std::max(shape.n, shape.m) <= max_degree;
}

Pair swapped(const Pair& pair) {
  return {{pair.shapes[1], pair.shapes[0]}, {pair.max_degrees[1], pair.max_degrees[0]}};
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

}  // namespace

std::optional<bool> Domain::order_of(const Query& query) const {
  if (pairs.empty()) return false;
  for (const bool is_swapped : {false, true}) {
    for (const Pair& pair : pairs) {
      const Shape& first = query.patches[is_swapped ? 1 : 0].shape;
      const Shape& second = query.patches[is_swapped ? 0 : 1].shape;
      if (fits(first, pair.shapes[0], pair.max_degrees[0]) &&
          fits(second, pair.shapes[1], pair.max_degrees[1])) {
        return is_swapped;
      }
    }
  }
  return std::nullopt;
}

bool Domain::has_bodies_of(const Query& query) const {
  return !is_of_bodies(query) ||
         std::ranges::all_of(query.patches, [&](const MovingPatch<double>& body) {
           return !body.faces.empty() ||
                  is_one_of(body_kinds, body.positions.size(), body.radius > 0);
         });
}

bool Domain::has_numbers_of(const Query& query) const {
  return (!scale || is_within_scale(query, *scale)) && (!binary32 || is_binary32(query)) &&
         (!plane || !is_of_bodies(query) || is_in_plane(query));
}

std::string Domain::broken_by(const Case& value) const {
  if (!has_bodies_of(value.query)) return "has no shape for one of these bodies";
  if (binary32 && !is_binary32(value.query)) return "takes floats, and a number of this is none";
  if (scale && !is_within_scale(value.query, *scale)) {
    return fmt::format("takes numbers that are 0 or within 2^±{}", *scale);
  }
  if (plane && is_of_bodies(value.query) && !is_in_plane(value.query)) {
    return "takes bodies in the plane z = 0";
  }
  if (ordinary && !plane && has_flat_body(value.query)) {
    return "takes bodies of four points or more that have a volume";
  }
  const Setting setting = ordinary ? setting_of(value) : Setting::kOrdinary;
  if (ordinary && setting == Setting::kOrdinary && is_shallow(value)) {
    return "takes contacts of some depth, and this is shallow";
  }
  if (setting == Setting::kOrdinary) return "";
  return fmt::format("takes ordinary queries, and this is {}", name_of(setting));
}

std::optional<Domain> Domain::with(const Domain& other) const {
  Domain both{{},
              common(body_kinds, other.body_kinds),
              scale,
              binary32 || other.binary32,
              ordinary || other.ordinary,
              plane || other.plane};
  if (other.scale) both.scale = std::min(scale.value_or(*other.scale), *other.scale);
  for (const Pair& a : pairs) {
    if (other.pairs.empty()) both.pairs.push_back(a);
    for (const Pair& given : other.pairs) {
      const Pair b = a.shapes == given.shapes ? given : swapped(given);
      if (a.shapes != b.shapes) continue;
      Pair& least = both.pairs.emplace_back(a);
      for (size_t s = 0; s < 2; ++s) {
        least.max_degrees[s] = std::min(a.max_degrees[s], b.max_degrees[s]);
      }
    }
  }
  if (pairs.empty()) both.pairs = other.pairs;
  const bool have_pairs = !both.pairs.empty() || (pairs.empty() && other.pairs.empty());
  const bool have_bodies =
      !both.body_kinds.empty() || (body_kinds.empty() && other.body_kinds.empty());
  return have_pairs && have_bodies ? std::optional(both) : std::nullopt;
}

std::string Domain::text() const {
  std::vector<std::string> rules;
  if (binary32) rules.emplace_back("floats");
  if (scale) rules.push_back(fmt::format("within 2^±{}", *scale));
  if (plane) rules.emplace_back("bodies in the plane z = 0");
  if (ordinary) rules.emplace_back("ordinary queries alone");
  return fmt::format("{}", fmt::join(rules, ", "));
}

}  // namespace ccdfuzz
