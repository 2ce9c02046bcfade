#pragma once

#include <string>

#include "properties/shrink.hpp"

namespace ccdfuzz {

/// What a user needs to see a failing property again.
struct CheckFind {
  Counterexample least;   ///< shrunk
  std::string reproduce;  ///< one command, for the shrunk input
  std::string test;       ///< a GoogleTest test that fails as long as the property does
};

/// Shrinks the failure of a property on these choices, by at most `tries` further runs of it.
CheckFind make_find(const Property& property, const ChoiceNumbers& numbers, std::uint64_t tries);

/// Makes the folder unless it is there. Errors: it cannot be made, or no file in it.
Result<void> make_find_folder(const std::string& folder);

/// Writes a find into a folder, as text to read; returns the path. Errors: of the folder or file.
Result<std::string> save_find(const std::string& folder, const Property& property,
                              const CheckFind& find);

}  // namespace ccdfuzz
