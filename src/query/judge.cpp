#include "query/judge.hpp"

#include <cmath>

#include "numeric/verify.hpp"

namespace ccdfuzz {

namespace {

bool is_nonsense(const Query& query, const Answer& answer) {
  const bool nan_toi = answer.toi && std::isnan(*answer.toi);
  switch (answer.verdict) {
    case Verdict::kHit:
      if (!answer.toi || nan_toi || *answer.toi < 0 || *answer.toi > query.t_max) return true;
      for (const Uv<double>& uv : answer.uv) {
        if (std::isnan(uv[0]) || std::isnan(uv[1])) return true;
      }
      return false;
    case Verdict::kUndecided:
      return nan_toi;
    case Verdict::kMiss:
      return false;  // carries no time; what stands there is not looked at
  }
  return true;
}

/// The time by which a contact has come, if that is in [0, t_max].
std::optional<Rational> proven_contact(const Truth& truth, double t_max) {
  std::optional<Rational> by = truth.contact_by();
  if (by && *by > exact(t_max)) by.reset();
  return by;
}

}  // namespace

Outcome judge(const Query& query, const Truth& truth, const Answer& answer) {
  if (is_nonsense(query, answer)) return Outcome::kError;
  if (answer.verdict == Verdict::kUndecided) return Outcome::kUndecided;
  const bool hit = answer.verdict == Verdict::kHit;
  if (const std::optional<Rational> contact = proven_contact(truth, query.t_max)) {
    if (!hit) return Outcome::kMissed;
    return exact(*answer.toi) > *contact ? Outcome::kLate : Outcome::kCorrect;
  }
  const bool clear =
      truth.collides == false || (truth.clear_until && *truth.clear_until > exact(query.t_max));
  if (!clear) return Outcome::kUnknown;
  return hit ? Outcome::kFalsePositive : Outcome::kCorrect;
}

Case with_t_max(const Case& value, double t_max) {
  CCDFUZZ_VERIFY(std::isfinite(t_max) && t_max >= 0);
  Case out = value;
  out.query.t_max = t_max;
  out.expect.clear();
  if (t_max == value.query.t_max) return out;
  const bool still_absent = value.truth.collides == false && t_max <= value.query.t_max;
  out.truth.collides.reset();
  if (still_absent) out.truth.collides = false;
  if (proven_contact(value.truth, t_max)) out.truth.collides = true;
  return out;
}

}  // namespace ccdfuzz
