#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/table.hpp"
#include "cli/check_find.hpp"
#include "cli/check_inputs.hpp"

namespace ccdfuzz {

/// What is told of one property.
struct CheckedProperty {
  const Property& property;
  CheckTally tally;
  std::string reproduce;          ///< the first failure
  std::optional<CheckFind> find;  ///< made of it where somebody wants to see it
  std::string saved;              ///< where it stands; empty where it need not or could not
  std::string not_saved;          ///< why not, as it was found or as it was shrunk

  bool known_false() const { return property.expected == Expectation::kFails; }
  bool is_finding() const { return tally.failed > 0 && !known_false(); }
  /// A claim that is known to be false, and these inputs do not show it.
  bool not_refuted() const { return known_false() && tally.failed == 0 && !tally.all_discarded(); }
};

/// For the rows of these.
Table check_table(const std::vector<Property>& properties);

/// Prints a find as it was found, and where that is saved.
void print_found(const CheckedProperty& checked);

/// Prints the table's next row.
void print_check_row(Table& table, const CheckedProperty& checked);

/// Prints what shrinking made of the find, and where that is saved.
void print_shrunk(const CheckedProperty& checked);

/// All of it as one JSON object.
void print_check_json(const CheckedInputs& inputs, const CheckedProperty& checked);

}  // namespace ccdfuzz
