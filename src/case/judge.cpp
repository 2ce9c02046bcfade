#include "case/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/double_parts.hpp"
#include "base/verify.hpp"
#include "bezier/blossom.hpp"
#include "bezier/exact_patch.hpp"
#include "bezier/trim_region.hpp"
#include "case/mesh.hpp"
#include "numeric/exact_scalars.hpp"
#include "numeric/next_double.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

bool is_nonsense(const Query& query, const Answer& answer) {
  const std::optional<double>& toi = answer.toi;
  switch (answer.verdict) {
    case Verdict::kHit: {
      const auto is_unknown = [](const Uv<double>& uv) { return is_nan(uv[0]) || is_nan(uv[1]); };
      return !toi || is_nan(*toi) || compare(*toi, 0) < 0 || compare(*toi, query.t_max) > 0 ||
             std::ranges::any_of(answer.uv, is_unknown);
    }
    case Verdict::kUndecided:
      return toi && is_nan(*toi);
    case Verdict::kMiss:
    case Verdict::kRefused:
      return false;  // carries no time; what stands there is not looked at
  }
  return true;
}

/// The time by which a contact has come, if that is in [0, t_max].
std::optional<Rational> within(std::optional<Rational> by, double t_max) {
  if (by && *by > exact(t_max)) by.reset();
  return by;
}

/// The contact by which a hit, or a miss, with these terms is judged. A method that leaves t_max
/// out may still hit there.
std::optional<Rational> binding_contact(const CheckedCase& known, bool hit,
                                        const AnswerTerms& terms) {
  const double t_max = known.query().t_max;
  std::optional<Rational> by = within(known.contact_by(), t_max);
  if (by && !hit && !terms.closed_t_max && *by == exact(t_max)) by.reset();
  if (by && !terms.contact_at_zero && *by == 0) by.reset();
  return by;
}

/// The parameters, finite, moved into the domain: rounding takes those of its edges out of it.
Uv<Rational> into_domain(const Shape& shape, const Uv<double>& uv) {
  const auto into = [](const Rational& x, const Rational& most) {
    return x < 0 ? Rational(0) : std::min(x, most);
  };
  const Rational u = into(exact(uv[0]), 1);
  const bool is_triangle = shape.kind == ShapeKind::kTriangle;
  return {u, into(exact(uv[1]), is_triangle ? Rational(1 - u) : Rational(1))};
}

/// The squared distance of a point on each patch from each other at time t.
Rational squared_distance(const Query& query, const std::array<Uv<Rational>, 2>& uv,
                          const Rational& t) {
  std::array<Vec3<Rational>, 2> points;
  for (size_t side = 0; side < 2; ++side) {
    points[side] = evaluate<Rational>(exact_patch<Rational>(query.patches[side]), uv[side], t);
  }
  const Vec3<Rational> way = points[0] - points[1];
  return dot(way, way);
}

/// Whether the two points that a hit names are at most so far apart at its toi.
bool is_near(const Query& query, const Answer& hit, double tolerance) {
  std::array<Uv<Rational>, 2> where;
  for (size_t side = 0; side < 2; ++side) {
    const Uv<double>& uv = hit.uv[side];
    if (!is_finite(uv[0]) || !is_finite(uv[1])) return false;
    TrimRegion region;
    region.assign(query.patches[side]);
    where[side] = into_domain(query.patches[side].shape, uv);
    if (!region.contains({round_down(where[side][0]), round_down(where[side][1])})) return false;
  }
  const Rational most = exact(query.separation) + exact(tolerance);
  return squared_distance(query, where, exact(*hit.toi)) <= most * most;
}

/// The squared distance of two hulls, at least; 0 where they are not shown to be apart. gap: along
/// the normal, times its length.
Rational squared_distance(const Rational& gap, const Vec3<Rational>& normal) {
  return gap > 0 ? Rational(gap * gap / dot(normal, normal)) : Rational(0);
}

/// The same at t, by the direction that keeps bodies apart.
Rational squared_distance(const Query& query, const BodyClearance& clearance, const Rational& t) {
  const Vec3<Rational>& normal = clearance.normal;
  std::array<std::vector<Rational>, 2> heights;
  for (size_t s = 0; s < 2; ++s) {
    for (const Vec3<Rational>& p : exact_patch<Rational>(query.patches[s]).at(t)) {
      heights[s].push_back(dot(normal, p));
    }
  }
  return squared_distance(
      *std::ranges::min_element(heights[1]) - *std::ranges::max_element(heights[0]), normal);
}

/// The same of the nearest face of a mesh. Nothing where the body meets backs of faces alone.
std::optional<Rational> squared_distance(const Query& query, const MeshClearance& clearance,
                                         const Rational& t) {
  std::vector<Rational> of_faces;
  for (const size_t face : faces_there(query)) {
    const size_t n = of_faces.size();
    of_faces.push_back(squared_distance(of_face(query, face), nth_of(clearance, n), t));
  }
  if (of_faces.empty()) return std::nullopt;
  return std::ranges::min(of_faces);
}

/// The same by the gap of the plane that is between them at t.
Rational squared_distance(const Query&, const BodyPlanes& clearance, const Rational& t) {
  const auto next = std::ranges::upper_bound(clearance.planes, t, {}, &BodyPlanes::Plane::from);
  const BodyPlanes::Plane& plane = *std::prev(next);
  const Rational until = next == clearance.planes.end() ? clearance.until : next->from;
  const Rational share =
      until == plane.from ? Rational(0) : Rational((t - plane.from) / (until - plane.from));
  const auto& [first, last] = plane.normals;
  return squared_distance(plane.gap, Vec3<Rational>(first + share * (last - first)));
}

/// What is no certificate of bodies does not show it.
template <class Other>
Rational squared_distance(const Query&, const Other&, const Rational&) {
  return 0;
}

std::optional<Rational> hulls_apart(const CheckedCase& known, double t) {
  return std::visit(
      [&](const auto& shown) -> std::optional<Rational> {
        return squared_distance(known.query(), shown, exact(t));
      },
      *known.clearance());
}

/// The distance of hulls at which bodies touch.
Rational reach(const Query& query) {
  return exact(query.separation) + exact(query.patches[0].radius) + exact(query.patches[1].radius);
}

}  // namespace

std::optional<Approach> approach_of(const Case& value) {
  const std::optional<Witness>& witness = value.truth.witness;
  if (!witness || compare(value.query.separation, 0) > 0 || is_of_bodies(value.query)) return {};
  return Approach{squared_distance(value.query, witness->uv, 0), witness->t};
}

std::optional<Rational> nearer_since(const CheckedCase& known, const AnswerTerms& terms,
                                     const Rational& before) {
  if (compare(terms.kept_separation, 0) == 0 || before == 0) return std::nullopt;
  const std::optional<Approach> approach = approach_of(known.value());
  if (!approach) return std::nullopt;
  const auto& [squared, until] = *approach;
  const Rational kept = exact(terms.kept_separation) * exact(terms.kept_separation);
  if (squared < kept) return terms.contact_at_zero ? std::optional<Rational>(0) : std::nullopt;
  const Rational left = before < until ? Rational(1 - before / until) : Rational(0);
  if (left * left * squared >= kept) return std::nullopt;
  // The root, at least: that of a double that is normal is off by less than one step.
  const double share =
      std::sqrt(std::max(round_up(kept / squared), std::numeric_limits<double>::min()));
  return std::max(Rational(0), Rational(until * (1 - exact(next_up(share)))));
}

Rational early_until(const Query& query, const Answer& answer, const AnswerTerms& terms) {
  const Rational until = exact(*answer.toi) + exact(terms.early_tolerance);
  return is_past_motion(query, round_up(until)) ? Rational(1) : until;
}

Outcome judge(const CheckedCase& known, const Answer& answer, const AnswerTerms& terms) {
  const Query& query = known.query();
  if (answer.verdict == Verdict::kRefused) return Outcome::kNotAsked;
  if (is_nonsense(query, answer)) return Outcome::kError;
  if (answer.verdict == Verdict::kUndecided) return Outcome::kUndecided;
  const bool hit = answer.verdict == Verdict::kHit;
  if (nearer_since(known, terms, exact(hit ? *answer.toi : query.t_max))) {
    return hit ? Outcome::kLate : Outcome::kMissed;
  }
  if (const auto contact = binding_contact(known, hit, terms)) {
    if (!hit) return Outcome::kMissed;
    const bool in_time = exact(*answer.toi) <= *contact + exact(terms.time_tolerance);
    return in_time ? Outcome::kCorrect : Outcome::kLate;
  }
  if (!hit && !terms.closed_t_max && known.is_clear_before_t_max()) return Outcome::kCorrect;
  if (!known.is_clear()) return Outcome::kUnknown;
  if (!hit) return Outcome::kCorrect;
  const Rational allowed = early_until(query, answer, terms);
  const bool may_be_early = compare(terms.early_tolerance, 0) > 0;
  if (const auto later = known.contact_by(); may_be_early && later && *later <= allowed) {
    return Outcome::kCorrect;
  }
  if (compare(terms.space_tolerance, 0) > 0) {
    if (is_of_bodies(query)) {
      const Rational most = reach(query) + exact(terms.space_tolerance);
      const std::optional<Rational> hulls = hulls_apart(known, *answer.toi);
      if (hulls && *hulls <= most * most) return Outcome::kUnknown;
    } else {
      if (!answer.has_uv) return Outcome::kUnknown;
      if (is_near(query, answer, terms.space_tolerance)) return Outcome::kCorrect;
    }
  }
  if (may_be_early && !covers(*known.clearance(), allowed)) {
    return Outcome::kUnknown;
  }
  return Outcome::kFalsePositive;
}

double apart_at(const CheckedCase& known, double t) {
  const std::optional<Rational> squared = hulls_apart(known, t);
  if (!squared) return 0;
  const double hulls = next_down(std::sqrt(round_down(*squared)));
  return round_down(exact(hulls) - reach(known.query()));
}

double delay_of(const CheckedCase& known, const Answer& answer, const AnswerTerms& terms) {
  const Rational toi = exact(*answer.toi);
  const std::optional<Rational> nearer = nearer_since(known, terms, toi);
  return round_up(toi - (nearer ? *nearer : *known.contact_by()));
}

Case with_t_max(const Case& value, double t_max) {
  CCDFUZZ_VERIFY(is_finite(t_max) && compare(t_max, 0) >= 0);
  Case out = value;
  out.query.t_max = t_max;
  out.expect.clear();
  if (compare(t_max, value.query.t_max) == 0) return out;
  const bool still_absent = value.truth.collides == false && compare(t_max, value.query.t_max) <= 0;
  out.truth.collides.reset();
  if (still_absent) out.truth.collides = false;
  if (within(value.truth.contact_by(), t_max)) out.truth.collides = true;
  return out;
}

bool CheckedCase::is_clear() const {
  return clearance_holds_ && covers(*value_.truth.clearance, exact(value_.query.t_max));
}

bool CheckedCase::is_clear_before_t_max() const {
  return clearance_holds_ && until_of(*value_.truth.clearance) >= exact(value_.query.t_max);
}

const Clearance* CheckedCase::clearance() const {
  return clearance_holds_ ? &*value_.truth.clearance : nullptr;
}

std::optional<bool> CheckedCase::collides() const {
  if (within(contact_by(), value_.query.t_max)) return true;
  return is_clear() ? std::optional(false) : std::nullopt;
}

CheckedCase CheckedCase::with_t_max(double t_max) const {
  return {ccdfuzz::with_t_max(value_, t_max), clearance_holds_};
}

}  // namespace ccdfuzz
