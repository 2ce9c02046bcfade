#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "properties/shrink.hpp"

namespace ccdfuzz {

/// Where finds of properties are, in a folder of finds.
inline constexpr const char* kPropertyFinds = "properties";
/// Runs of a property to shrink a failure of it.
inline constexpr std::uint64_t kShrinkTries = 4000;

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
/// The same of one draw.
std::string check_command(const Property& property, std::uint64_t seed, std::uint64_t index);

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

/// What has been done of a find, and how large the input is that shows it.
struct FindQuality {
  enum class State : std::uint8_t {
    kAsFound,   ///< it has not failed again
    kCutShort,  ///< not shrunk to the end
    kComplete,  ///< nothing is left to do
  };
  State state = State::kAsFound;
  std::size_t bytes = 0;  ///< of the shrunk input

  bool is_complete() const { return state == State::kComplete; }
  /// Whether it takes the place of another find of its kind: it is better known, or shrunk to less;
  /// of two that have not failed again, the later is as good as the former.
  bool replaces(const FindQuality& other) const;
};
FindQuality quality_of(const CheckFind& find);

/// A file that save_find wrote.
struct SavedFind {
  std::string path, kind;
  FindQuality quality;
};
/// All of a folder; none where there is none.
std::vector<SavedFind> saved_finds(const std::string& folder);

}  // namespace ccdfuzz
