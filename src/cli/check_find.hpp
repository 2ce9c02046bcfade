#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.hpp"
#include "properties/shrink.hpp"

namespace ccdfuzz {

/// Where finds of properties are, in a folder of finds.
inline constexpr const char* kPropertyFinds = "properties";
/// Runs of a property to shrink a failure of it.
inline constexpr std::uint64_t kShrinkTries = 4000;

/// The command that puts these bytes to a property.
std::string check_command(std::string_view property, std::span<const std::uint8_t> bytes);
/// The same of one draw.
std::string check_command(std::string_view property, std::uint64_t seed, std::uint64_t index);

/// What has been done of a find.
enum class Shrunk : std::uint8_t {
  kNot,       ///< it has not failed again
  kCutShort,  ///< not to the end
  kToTheEnd,  ///< nothing is left to do
};
inline constexpr std::array kAllShrunk = {Shrunk::kNot, Shrunk::kCutShort, Shrunk::kToTheEnd};
/// "not", "cut short", "to the end".
std::string_view name_of(Shrunk shrunk);
constexpr const auto& all_of(Shrunk) {
  return kAllShrunk;
}

/// What a user needs to see a failing property again: a find as it stands in its file.
struct ClaimFind {
  std::string property, claim;
  std::string error;  ///< the name of what the input ended in ("crash SIGSEGV"); mostly none
  Shrunk shrunk = Shrunk::kNot;
  std::string input;              ///< the shrunk one, in hex; empty before
  std::string text, reproduce;    ///< what it showed, and one command; empty before
  std::vector<std::string> test;  ///< lines of a GoogleTest test that fails as the property does
  std::string found, as_found;    ///< text and command of the input that failed first

  static void fields(auto& archive, auto& find) {
    archive.format("ccdfuzz-claim-find", 1, 1);
    archive("property", find.property);
    archive("claim", find.claim);
    archive("error", find.error);
    archive("shrunk", find.shrunk);
    archive("text", find.text);
    archive("input", find.input);
    archive("reproduce", find.reproduce);
    archive("test", find.test);
    archive("found", find.found);
    archive("as_found", find.as_found);
  }

  ClaimFind() = default;
  ClaimFind(const Property& property, std::string error, std::string text, std::string command);

  /// The test as one text; empty before.
  std::string test_text() const;

  /// Sets what it was shrunk to, with command and test.
  void set_least(const Counterexample& least);

  bool is_complete() const { return shrunk == Shrunk::kToTheEnd; }
  /// Whether it takes the place of another find of its claim and error: it is shrunk further, or to
  /// less. Of two that have not failed again, the later is as good as the former.
  bool replaces(const ClaimFind& other) const;
};

/// Makes the folder unless it is there. Errors: it cannot be made, or no file in it.
Result<void> make_find_folder(const std::string& folder);

/// The find of a property and an error that stands in a folder. Errors: a file that is none.
Result<std::optional<ClaimFind>> saved_find(const std::string& folder, const std::string& property,
                                            const std::string& error);

/// Puts a find into the file that is called by its property and error, unless it does not replace
/// what stands there. Returns the path. Errors: of the folder or file.
Result<std::string> save_find(const std::string& folder, const ClaimFind& find);

}  // namespace ccdfuzz
