#pragma once

#include <optional>
#include <string>

#include "properties/shrink.hpp"

namespace ccdfuzz {

/// What a user needs to see a failing property again.
struct CheckFind {
  std::string text, as_found;           ///< of the input that failed: what it showed; one command
  std::optional<Counterexample> least;  ///< shrunk; none before that, or where it does not repeat
  std::string reproduce;                ///< one command, for the shrunk input
  std::string test;  ///< a GoogleTest test that fails as long as the property does
};

/// Shrinks the failure of a property on these choices.
void shrink_find(CheckFind& find, const Property& property, const ChoiceNumbers& numbers,
                 const ShrinkLimits& limits);

/// Makes the folder unless it is there. Errors: it cannot be made, or no file in it.
Result<void> make_find_folder(const std::string& folder);

/// Writes a find into a folder, as text to read; returns the path, which is of the property and of
/// the simplest input that is known. Errors: of the folder or file.
Result<std::string> save_find(const std::string& folder, const Property& property,
                              const CheckFind& find);

}  // namespace ccdfuzz
