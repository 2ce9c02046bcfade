#include "certify/checker/check_truth.hpp"

#include <fmt/format.h>

#include "certify/checker/check_witness.hpp"

namespace ccdfuzz {

Result<void> check_truth(const Case& value) {
  const Truth& truth = value.truth;
  if (auto valid = validate(value.query, ""); !valid) return valid;
  if (truth.collides == true && !truth.witness) {
    return input_error("truth.witness", "missing, though collides is true");
  }
  if (truth.witness) {
    auto checked = truth.collides == true ? check_witness(value.query, *truth.witness)
                                          : check_contact(value.query, *truth.witness);
    if (!checked) return checked;
    if (truth.collides == false && truth.witness->t <= exact(value.query.t_max)) {
      return input_error("truth.collides",
                         fmt::format("false, but the witness proves a contact at t = {} ≤ t_max",
                                     to_text(truth.witness->t)));
    }
  }
  if (truth.clear_until) {
    const std::string until = to_text(*truth.clear_until);
    if (*truth.clear_until < 0) {
      return input_error("truth.clear_until", fmt::format("{} is negative", until));
    }
    if (truth.witness && truth.witness->t < *truth.clear_until) {
      return input_error("truth.clear_until",
                         fmt::format("{}, but the witness proves a contact at t = {} before it",
                                     until, to_text(truth.witness->t)));
    }
  }
  return {};
}

Result<std::vector<NamedCase>> read_checked_cases(const std::string& path) {
  std::vector<NamedCase> cases;
  const auto read = for_each_case(path, [&](NamedCase c) -> Result<void> {
    if (auto checked = check_truth(c.value); !checked) {
      InputError error = checked.error();
      error.where = fmt::format("{}: {}", c.id, error.where);
      return tl::unexpected(error);
    }
    cases.push_back(std::move(c));
    return {};
  });
  if (!read) return tl::unexpected(read.error());
  return cases;
}

}  // namespace ccdfuzz
