#include "certify/oracle/complete_truth.hpp"

#include <fmt/format.h>

#include "base/verify.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"

namespace ccdfuzz {

namespace {

/// The latest time up to which the case claims that nothing touches.
std::optional<Rational> claimed_clear(const Case& value) {
  std::optional<Rational> until = value.truth.clear_until;
  const Rational t_max = exact(value.query.t_max);
  if (value.truth.collides == false && (!until || *until < t_max)) until = t_max;
  return until;
}

/// True iff x proves absence for a longer time than y.
bool reaches_further(const Clearance& x, const Clearance& y) {
  return until_of(x) > until_of(y) || (until_of(x) == until_of(y) && covers(x, until_of(x)));
}

/// Takes over the case's own clearance, which holds, if it reaches further than the one found.
void keep_better_clearance(const Case& value, Decision& found) {
  const auto& own = value.truth.clearance;
  if (!own) return;
  if (found.truth.clearance && !reaches_further(*own, *found.truth.clearance)) return;
  found.truth.clearance = own;
  conclude(value.query, found.truth);
}

/// Takes over the case's own contact if it is earlier than what was found. A contact after t_max is
/// no part of a decision.
void keep_contact(const Truth& own, Truth& found) {
  const std::optional<Rational> contact = found.contact_by();
  if (contact && !(own.contact_by() && *own.contact_by() < *contact)) return;
  found.witness = own.witness;
  found.contact_box = own.contact_box;
  found.contact_root = own.contact_root;
}

}  // namespace

Completed complete_truth(const Case& value, OracleOptions options) {
  const std::optional<Rational> claimed = claimed_clear(value);
  options.known = value.truth.witness;
  options.wanted_clear = claimed;
  Decision found = decide(value.query, options);
  Completed out{value, false, found.note};
  Truth& truth = out.value.truth;

  const std::optional<Rational> contact = found.truth.contact_by();
  const auto holds = truth.clearance ? check_absence(value) : Result<void>();
  // Neither proven nor refuted: then the case's own word of absence counts for nothing.
  const bool is_unknown = !holds && holds.error().is_limit;
  const bool touches_by_end =
      value.truth.collides == false && contact && *contact <= exact(value.query.t_max);
  if (!holds && !is_unknown) {
    out.refuted = true;
    out.note = holds.error().message();
  } else if (touches_by_end || (contact && claimed && *contact < *claimed)) {
    out.refuted = true;
    out.note = fmt::format("claimed clear until t = {}, but there is a contact by t = {}",
                           to_text(*claimed), to_text(*contact));
  } else if (is_unknown) {
    out.note = holds.error().message();
    keep_contact(truth, found.truth);
  } else {
    keep_better_clearance(value, found);
    const auto& until = found.truth.clear_until;
    if (claimed && found.truth.collides != false && (!until || *until < *claimed)) {
      // The claim stands as it is, and is still to be proven by other means.
      found.truth.clearance.reset();
      found.truth.clear_until = truth.clear_until;
      found.truth.proof = truth.proof;
      if (!found.truth.collides) found.truth.collides = truth.collides;
    }
    keep_contact(truth, found.truth);
  }
  truth = found.truth;
  CCDFUZZ_VERIFY(check_truth(out.value));
  return out;
}

}  // namespace ccdfuzz
