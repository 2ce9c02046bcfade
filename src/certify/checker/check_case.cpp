#include "certify/checker/check_case.hpp"

#include "certify/checker/abbreviated.hpp"
#include "certify/checker/check_truth.hpp"

namespace ccdfuzz {

Result<void> check_absence(const Case& value) {
  const Truth& truth = value.truth;
  if (!truth.clearance) return input_error("truth.certificate.clear", "missing");
  const std::string until = abbreviated(until_of(*truth.clearance));
  if (truth.collides == false && !covers(*truth.clearance, exact(value.query.t_max))) {
    return input_error("truth.certificate.clear.until", "{} does not reach past t_max = {}", until,
                       value.query.t_max);
  }
  if (truth.clear_until && *truth.clear_until > until_of(*truth.clearance)) {
    return input_error("truth.certificate.clear.until", "{} is before clear_until = {}", until,
                       abbreviated(*truth.clear_until));
  }
  return check_clearance(value.query, *truth.clearance);
}

Result<CheckedCase> check_case(Case value) {
  CCDFUZZ_TRY_VOID(check_truth(value));
  const bool has_clearance = value.truth.clearance.has_value();
  if (has_clearance) {
    CCDFUZZ_TRY_VOID(check_absence(value));
  }
  return CheckedCase(std::move(value), has_clearance);
}

CheckedCase checked_or_unknown(const Case& value) {
  if (auto checked = check_case(value)) return *std::move(checked);
  Case bare = value;
  bare.truth = {};
  return {std::move(bare), false};
}

CheckedCase checked_contact(Case value) {
  value.truth.clearance.reset();
  value.truth.clear_until.reset();
  return checked_or_unknown(value);
}

}  // namespace ccdfuzz
