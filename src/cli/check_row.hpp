#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/check_find.hpp"
#include "cli/check_inputs.hpp"
#include "eval/table.hpp"

namespace ccdfuzz {

/// What is told of one property.
struct CheckedProperty {
  const Property& property;
  CheckTally tally;
  std::string reproduce;          ///< the first failure
  std::optional<CheckFind> find;  ///< made of it
  Result<std::string> saved;      ///< path; empty if there was no need

  bool known_false() const { return property.expected == Expectation::kFails; }
  bool is_finding() const { return tally.failed > 0 && !known_false(); }
};

/// For the rows of these.
Table check_table(const std::vector<Property>& properties);

/// Prints the table's next row, and under it the find if there is one.
void print_check_row(Table& table, const CheckedProperty& checked);

/// The same as one JSON object.
void print_check_json(const CheckedInputs& inputs, const CheckedProperty& checked);

}  // namespace ccdfuzz
