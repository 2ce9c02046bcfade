#pragma once

#include "case/case.hpp"

namespace ccdfuzz {

/// A case whose truth was checked: what answers are judged by. Only the checker makes one that
/// knows anything (check_case), so that no answer is judged by what a file merely says.
class CheckedCase {
 public:
  /// Nothing is known of it.
  CheckedCase() = default;

  const Case& value() const { return value_; }
  const Query& query() const { return value_.query; }
  /// A time by which a contact is proven; it may be past t_max.
  std::optional<Rational> contact_by() const { return value_.truth.contact_by(); }
  /// A proven contact, of any time.
  const std::optional<Witness>& witness() const { return value_.truth.witness; }
  /// True iff a checked certificate proves that nothing touches in [0, t_max].
  bool is_clear() const;
  /// True iff it proves that for the half-open [0, t_max).
  bool is_clear_before_t_max() const;
  /// The checked certificate of absence; null if there is none.
  const Clearance* clearance() const;
  /// Whether the patches touch in [0, t_max], as far as it is proven.
  std::optional<bool> collides() const;
  /// The same two patches asked up to another t_max ≥ 0, as with_t_max; what was proven stays so.
  CheckedCase with_t_max(double t_max) const;

  friend bool operator==(const CheckedCase&, const CheckedCase&) = default;

 private:
  friend Result<CheckedCase> check_case(Case value);
  friend CheckedCase checked_or_unknown(const Case& value);
  CheckedCase(Case value, bool clearance_holds)
      : value_(std::move(value)), clearance_holds_(clearance_holds) {}

  Case value_;
  bool clearance_holds_ = false;
};

}  // namespace ccdfuzz
