#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "base/enum_names.hpp"
#include "io/fields.hpp"
#include "properties/shrink.hpp"

namespace ccdfuzz {

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
  /// as_found: a command that shows what failed first.
  ClaimFind(const Property& property, std::string error, std::string text, std::string as_found);

  /// The name of its file in a folder of finds, without ".json".
  std::string stem() const;

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

}  // namespace ccdfuzz
