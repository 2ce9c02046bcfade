#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/enum_names.hpp"
#include "base/result.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// The result of a property on one input.
struct Check {
  enum class Status : std::uint8_t {
    kHolds,
    kFails,
    kDiscarded,  ///< the input is outside what the claim speaks of
  };
  Status status = Status::kHolds;
  /// Fails: what does not hold, and every value that was shown, doubles as hex floats, so that the
  /// text alone gives the input back. Discarded: why.
  std::string text;

  static Check holds() { return {}; }
  static Check discarded(std::string why) { return {Status::kDiscarded, std::move(why)}; }
  static Check fails(std::string text) { return {Status::kFails, std::move(text)}; }
};

/// The result as a verb: the property "holds", "fails" or "is discarded".
constexpr std::array<std::string_view, 3> names_of(Check::Status) {
  return {"holds", "fails", "is discarded"};
}

/// Whether a claim is expected to hold. A claim that is false stays as it was made, and is marked.
enum class Expectation : std::uint8_t {
  kHolds,  ///< no counterexample is known; one is a finding
  kFails,  ///< counterexamples are known, and not to find one means that the harness is broken
};

/// An input does not keep a claim; what() says which condition.
struct Refuted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Within a check: this must hold of the input. The text of the condition is the first line of the
/// failure; what show() names follows.
#define CLAIM(...)                                                           \
  do {                                                                       \
    if (!(__VA_ARGS__)) throw ::ccdfuzz::Refuted("not true: " #__VA_ARGS__); \
  } while (false)

/// Within a check: the claim speaks of inputs of which this is true, and of no others.
inline void suppose(bool condition) {
  if (!condition) throw Discarded();
}
/// The value of a draw that can fail: a Result or an optional. Discarded where there is none.
template <class Drawn>
auto supposed(Drawn drawn) {
  suppose(drawn.has_value());
  return *std::move(drawn);
}

/// One claim, checked by any driver: GoogleTest and RapidCheck (tests/properties), libFuzzer and
/// replay (fuzz), none of which it knows.
struct Property {
  std::string name;    ///< "subject.claim", unique
  std::string claim;   ///< in words, one sentence
  std::string source;  ///< the claim's: a section of the paper, a file
  /// Draws an input and checks the claim on it, by CLAIM and suppose. The same choices give the
  /// same result.
  std::function<void(Draw&)> check;
  Expectation expected = Expectation::kHolds;
  /// The check of a claim about any method, for the one of this spec. `check` is for some that are
  /// built in. Null if the claim says itself which methods it is about.
  std::function<void(Draw&, const std::string& method)> check_of = {};
  std::string method = {};  ///< that spec, in what about() made
};

/// A claim about any method, of this one; the claim itself where no method is named. Errors: the
/// claim says itself which methods it is about.
Result<Property> about(Property claim, const std::string& method);
/// "NAME of METHOD", or the name.
std::string title_of(const std::string& property, const std::string& method);

/// Checks a property on an input. An exception is a failure, except
/// std::bad_alloc, which passes to whoever limits memory. A failure is described by checking the
/// same choices once more while show() listens; not if `tells` is false: who counts need not pay
/// for it.
Check run(const Property& property, Draw& choices, bool tells = true);

}  // namespace ccdfuzz
