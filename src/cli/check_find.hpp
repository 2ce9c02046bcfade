#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/enum_names.hpp"
#include "io/fields.hpp"
#include "properties/shrink.hpp"

namespace ccdfuzz {

/// How often a property runs at most, to shrink one of its failures.
inline constexpr std::uint64_t kShrinkTries = 4000;

/// Why no method can be named for a claim.
inline constexpr const char* kOfItsOwn = "the claim says itself which methods it is about";

/// The command that runs a property on what follows: choices, or one draw. method: that of a claim
/// about() one; otherwise empty.
std::string check_command(const std::string& property, const std::string& method,
                          const std::string& on);
/// The options that are these choices, or one draw.
std::string words_of(const ChoiceNumbers& choices);
std::string words_of(std::uint64_t seed, std::uint64_t index);

/// How far a find has been shrunk.
enum class Shrunk : std::uint8_t {
  kNot,       ///< it has not failed again
  kCutShort,  ///< not to the end
  kToTheEnd,  ///< nothing is left to do
};
constexpr std::array<std::string_view, 3> names_of(Shrunk) {
  return {"not", "cut short", "to the end"};
}

/// An input of a property that is worth keeping, as its file has it: a find, or an entry of a
/// corpus.
struct ClaimFind {
  std::string property, claim;
  std::string method;                            ///< of a claim about() one: its spec
  Check::Status expect = Check::Status::kFails;  ///< what it must show when it is replayed
  std::string error;  ///< the name of what the input ended in ("crash SIGSEGV"); mostly none
  Shrunk shrunk = Shrunk::kNot;
  ChoiceNumbers choices;        ///< the input that it was shrunk to; empty before
  std::string text;             ///< what that showed; empty before
  std::string found, as_found;  ///< text and command of the input that failed first

  static void fields(auto& archive, auto& find) {
    archive.format("ccdfuzz-claim", 1, 1);
    archive("property", find.property);
    archive("claim", find.claim);
    archive.optional("method", find.method);
    archive("expect", find.expect);
    archive.optional("error", find.error);
    archive("shrunk", find.shrunk);
    archive("text", find.text);
    archive("choices", find.choices);
    archive.optional("found", find.found);
    archive.optional("as_found", find.as_found);
  }

  ClaimFind() = default;
  /// on: words_of what it failed on first.
  ClaimFind(const Property& property, std::string error, std::string text, const std::string& on);

  /// The name of its file in a folder of finds, without ".json".
  std::string stem() const;
  /// One command that shows what it was shrunk to, or what failed first.
  std::string reproduce() const;

  /// Sets what it was shrunk to.
  void set_least(const Counterexample& least);

  bool is_complete() const { return shrunk == Shrunk::kToTheEnd; }
  std::pair<std::string, ChoiceNumbers> input() const {
    return {title_of(property, method), choices};
  }
  /// Whether it replaces another find of its claim and error: it is shrunk further, or to less, or
  /// neither has failed again.
  bool replaces(const ClaimFind& other) const;

  bool operator==(const ClaimFind&) const = default;
};

/// Where the finds of claims are in a corpus or a folder of finds.
std::string claims_in(const std::string& corpus);
/// Whether the path is that of such a folder itself: the first entry in it is a find of a claim.
/// Where there is none, by its name (kClaims). A corpus may have that name, too, and has one
/// inside.
bool is_claims_folder(const std::string& path);

/// The files of a corpus, which has cases and finds of claims.
struct CorpusFiles {
  std::vector<std::string> cases, claims;
};
/// Those of a corpus, or of a folder of claims, which has no cases. A path of a file is a claim if
/// it can be read as one, and a case if not. Errors: a folder cannot be read.
Result<CorpusFiles> cases_and_claims(const std::string& corpus);

/// The find in a file. Errors: it cannot be read, or is no find.
Result<ClaimFind> read_find(const std::string& path);
/// The text of its file.
std::string file_text(const ClaimFind& find);

/// The find of the same property and error in a folder, if it expects the same. Errors: a file that
/// is no find.
Result<std::optional<ClaimFind>> saved_find(const std::string& folder, const ClaimFind& like);

struct SavedFind {
  std::string path;
  bool is_new = true;  ///< else what was there stays
  std::optional<ClaimFind> replaced = {};
};

/// Puts a find into the file of this name, without ".json", or else of its stem(). Under its stem
/// it takes the place of one that it replaces. An entry of another name, or that expects something
/// else, stays, and the find is named by its hash. Errors: of the folder or file.
Result<SavedFind> save_find(const std::string& folder, const ClaimFind& find,
                            const std::string& name = "");

}  // namespace ccdfuzz
