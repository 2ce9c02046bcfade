#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "properties/shrink.hpp"

namespace ccdfuzz {

/// What a user needs to see a failing property again.
struct CheckFind {
  std::string text, as_found;  ///< of the input that failed: what it showed; one command
  std::string error;           ///< the name of what it ended in ("crash SIGSEGV"); mostly none
  std::optional<Counterexample> least;  ///< shrunk; none before that, or where it does not repeat
  std::string reproduce;                ///< one command, for the shrunk input
  std::string test;  ///< a GoogleTest test that fails as long as the property does
};

/// The command that puts these bytes to a property.
std::string check_command(const Property& property, std::span<const std::uint8_t> bytes);
/// The same of one draw (draws_of).
std::string check_command(const Property& property, std::uint64_t seed);

/// What a find was shrunk to, with command and test.
void set_least(CheckFind& find, const Property& property, Counterexample least);

/// Makes the folder unless it is there. Errors: it cannot be made, or no file in it.
Result<void> make_find_folder(const std::string& folder);

/// Writes a find into a folder, as text to read; returns the path, which is of the property and of
/// the simplest input that is known. Errors: of the folder or file.
Result<std::string> save_find(const std::string& folder, const Property& property,
                              const CheckFind& find);

/// What saved finds are told apart by: the property, and an error's name.
std::string kind_of_find(const Property& property, const CheckFind& find);
/// The same of a file that save_find wrote, by its name; none of any other.
std::optional<std::string> kind_of_find(const std::string& file_name);

}  // namespace ccdfuzz
