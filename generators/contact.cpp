#include "generators/contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bezier/bernstein.hpp"
#include "bezier/trim_region.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/outcome_of.hpp"
#include "generators/shaped/features.hpp"
#include "numeric/small_dyadic.hpp"

namespace ccdfuzz {

namespace {

template <class S>
std::vector<S> weights_at(const MovingPatch<double>& patch, const Uv<S>& uv) {
  std::vector<S> weights = bernstein_weights<S>(patch.shape, uv);
  for (size_t i = 0; i < patch.weights.size(); ++i) {
    weights[i] = weights[i] * S::exact(patch.weights[i]);
  }
  return weights;
}

std::vector<SmallDyadic> small_weights(const Contact& q, size_t side) {
  const Uv<Dyadic>& uv = q.uv[side];
  return weights_at<SmallDyadic>(q.query.patches[side],
                                 {SmallDyadic::of(uv[0]), SmallDyadic::of(uv[1])});
}

/// Σ weight·(position + t·velocity), or of ends Σ weight·((1 − t)·position + t·end).
template <class S>
std::array<S, 3> weighted_sum(const MovingPatch<double>& patch, const std::vector<S>& weights,
                              const S& t) {
  std::array<S, 3> sum;
  const S rest = patch.has_ends() ? S(1) - t : S(1);
  for (size_t i = 0; i < weights.size(); ++i) {
    if (weights[i].sign() == 0) continue;
    const S weighted_t = weights[i] * t, weighted_rest = weights[i] * rest;
    for (size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double position = patch.positions[i][axis], move = patch.moves()[i][axis];
      if (position != 0) sum[k] += weighted_rest * S::exact(position);
      if (move != 0) sum[k] += weighted_t * S::exact(move);
    }
  }
  return sum;
}

bool lets_through(double t_max, const Rational& t, const Answer& answer, const AnswerTerms& terms) {
  if (!terms.contact_at_zero && t == 0) return false;
  if (!terms.closed_t_max && t == exact(t_max)) return false;
  if (answer.verdict != Verdict::kHit) return answer.verdict == Verdict::kMiss;
  const double at = answer.toi.value_or(HUGE_VAL);
  if (!is_finite(at) || exact(at) < 0 || exact(at) > exact(t_max)) return true;
  return exact(at) > t + exact(terms.time_tolerance);
}

/// "0.25 (0x1p-2)".
std::string time_text(double t) {
  return fmt::format("{} ({})", t, to_hex(t));
}

/// "answered hit at 0.5 (0x1p-1)".
std::string answer_text(const Answer& answer) {
  const std::string text = fmt::format("answered {}", name_of(answer.verdict));
  return answer.has_toi() ? text + " at " + time_text(*answer.toi) : text;
}

/// The contact's time, or the two doubles around it where it is none; and what is tolerated.
std::string contact_text(const Rational& t, const AnswerTerms& terms) {
  const double before = round_down(t), after = round_up(t);
  std::string text = time_text(before);
  if (exact(before) != t) text += " to " + time_text(after);
  if (compare(terms.time_tolerance, 0) == 0) return text;
  return text + fmt::format("; a hit may be {} later", terms.time_tolerance);
}

}  // namespace

std::vector<Dyadic> Contact::weights(size_t side) const {
  const std::vector<SmallDyadic> small = small_weights(*this, side);
  if (!std::ranges::all_of(small, &SmallDyadic::fits)) {
    return weights_at(query.patches[side], uv[side]);
  }
  std::vector<Dyadic> weights;
  weights.reserve(small.size());
  for (const SmallDyadic& x : small) weights.push_back(x.dyadic());
  return weights;
}

Dyadic Contact::weight(size_t side) const {
  Dyadic sum(1);
  if (query.patches[side].weights.empty()) return sum;
  sum = Dyadic();
  for (const Dyadic& w : weights(side)) sum += w;
  return sum;
}

Vec3<Dyadic> Contact::offset() const {
  const Vec3<Dyadic> a = point(0), b = point(1);
  if (query.patches[0].weights.empty() && query.patches[1].weights.empty()) return a - b;
  return a * weight(1) - b * weight(0);
}

Vec3<Dyadic> Contact::point(size_t side) const {
  const MovingPatch<double>& patch = query.patches[side];
  const auto small = weighted_sum(patch, small_weights(*this, side), SmallDyadic::of(t));
  if (small[0].fits() && small[1].fits() && small[2].fits()) {
    return {small[0].dyadic(), small[1].dyadic(), small[2].dyadic()};
  }
  const auto sum = weighted_sum(patch, weights_at(patch, uv[side]), t);
  return {sum[0], sum[1], sum[2]};
}

bool is_in_trims(const Contact& q) {
  for (size_t s = 0; s < 2; ++s) {
    TrimRegion region;
    region.assign(q.query.patches[s]);
    if (region.is_whole()) continue;
    const auto u = q.uv[s][0].to_double_exactly(), v = q.uv[s][1].to_double_exactly();
    if (!u || !v || !region.contains({*u, *v})) return false;
  }
  return true;
}

std::optional<Contact> near_contact_of(const Case& known) {
  const std::optional<Witness>& witness = known.truth.witness;
  if (!witness || witness->t > exact(known.query.t_max)) return std::nullopt;
  if (is_of_bodies(known.query)) return std::nullopt;
  const auto near = [](const Rational& x) {
    if (const std::optional<Dyadic> same = Dyadic::from(x)) return *same;
    const Integer parts = x.get_num() * 32 / x.get_den();
    return Dyadic(parts == 0 ? Integer(1) : parts, -5);
  };
  Contact q{known.query, near(witness->t), {}};
  for (size_t s = 0; s < 2; ++s) {
    const auto& [u, v] = witness->uv[s];
    q.uv[s] = {near(u), near(v)};
    if (known.query.patches[s].shape.kind != ShapeKind::kTriangle) continue;
    // On the long side of a triangle it stays there, and what is inside must stay inside.
    if (u + v == 1) {
      q.uv[s][1] = Dyadic(1) - q.uv[s][0];
    } else if ((Dyadic(1) - q.uv[s][0] - q.uv[s][1]).sign() <= 0) {
      return std::nullopt;
    }
  }
  return q;
}

std::optional<Contact> contact_of(const Case& known) {
  const std::optional<Contact> q = near_contact_of(known);
  if (!q || !(q->witness() == *known.truth.witness)) return std::nullopt;
  if (known.query.separation > 0 && q->offset() != Vec3<Dyadic>()) return std::nullopt;
  return q;
}

ContactClass contact_class_of(const Contact& q) {
  const auto& [a, b] = q.query.patches;
  return class_between(feature_at(a.shape, q.uv[0]), feature_at(b.shape, q.uv[1]));
}

Witness Contact::witness() const {
  Witness w{t.rational(), {}};
  for (size_t s = 0; s < 2; ++s) w.uv[s] = {uv[s][0].rational(), uv[s][1].rational()};
  return w;
}

Contact falling_point() {
  Contact q;
  q.query.patches[0] = {Shape::point(), {{0, 0, 1}}, {{0, 0, -1}}};
  q.query.patches[1] = {Shape::curve(1), {{-1, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  q.t = Dyadic(1);
  q.uv[1][0] = Dyadic(Integer(1), -1);
  return q;
}

/// What programs judge by, not what a plug-in claims, which is checked when it starts.
static void demand(const AnswerTerms& terms) {
  for (const auto& [name, value] : std::initializer_list<std::pair<const char*, double>>{
           {"time_tolerance", terms.time_tolerance},
           {"space_tolerance", terms.space_tolerance},
           {"depth_tolerance", terms.depth_tolerance},
           {"early_tolerance", terms.early_tolerance},
           {"kept_separation", terms.kept_separation}}) {
    if (value >= 0 && std::isfinite(value)) continue;
    throw std::invalid_argument(fmt::format("{}: {} is not finite and at least 0", name, value));
  }
}

Explained is_false_negative(const Contact& contact, const Answer& answer,
                            const AnswerTerms& terms) {
  demand(terms);
  const Rational t = contact.t.rational();
  return {lets_through(contact.query.t_max, t, answer, terms),
          fmt::format("{}; they touch at t = {}", answer_text(answer), contact_text(t, terms))};
}

Explained is_wrong(const Case& known, const Answer& answer, const AnswerTerms& terms) {
  demand(terms);
  const CheckedCase checked = checked_or_unknown(known);
  const Outcome outcome = outcome_of(checked, answer, terms, false);
  const std::optional<bool> collides = checked.collides();
  const std::string proven = !collides ? "nothing is proven of contacts"
                             : *collides
                                 ? "contact by t = " + contact_text(*checked.contact_by(), terms)
                                 : "no contact in [0, t_max]";
  return {is_failure(outcome),
          fmt::format("{}: {}; {}", name_of(outcome), answer_text(answer), proven)};
}

Case case_of(const Contact& q) {
  Case out;
  out.origin.contact = name_of(contact_class_of(q));
  out.origin.kind = name_of(CaseKind::kRP);
  out.origin.generator = "mutant";
  out.query = q.query;
  out.truth.collides = true;
  out.truth.witness = q.witness();
  return out;
}

}  // namespace ccdfuzz
