#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_names.hpp"
#include "method/ask.hpp"
#include "method/setting.hpp"

namespace ccdfuzz {

/// How a method fails; what a store keeps one find for.
struct Failure {
  std::string who;  ///< the method's spec
  Outcome outcome = Outcome::kUnknown;
  std::string contact;  ///< the class of the contact; empty for an error
  /// An error's name ("hang"), what lost a contact ("left root"), of bodies their kind; or empty.
  std::string cause;
  Setting setting = Setting::kOrdinary;  ///< ordinary for an error: a crash is a crash

  auto operator<=>(const Failure&) const = default;

  static void fields(auto& archive, auto& failure) {
    archive("method", failure.who);
    archive("outcome", failure.outcome);
    archive("class", failure.contact);
    archive("cause", failure.cause);
    archive("setting", failure.setting);
  }
};

/// The failure that an expectation of a case states. Requires is_failure(expected.outcome).
Failure failure_of(const Case& value, const std::string& method, const Expected& expected);

/// Makes origin.version of a find what the method says of its version. Its depth and what the judge
/// allows, where they are above 0, become origin.depth, depth_tolerance (of bodies alone) and
/// time_tolerance. It is for plug-ins that say their version; others say nothing.
void say_version(Case& find, const std::string& method, const Judged& judged = {});

/// The same, if origin.version is what the method says.
void say_depth(Case& find, const std::string& method, const Judged& judged);

/// Makes a find say what it does not and another of its query does: what say_version takes from
/// a judge, of the same version.
void take_depth(Case& find, const Case& other);

/// The failures that a case expects, method by method.
std::vector<Failure> failures_of(const Case& value);

/// "missed by tdibm-e (VE, left root, extreme)".
std::string to_text(const Failure& failure);

/// A file name without its ending, of letters, digits and "._-" alone: the same for equal failures,
/// another for others ("tdibm-e-missed-VE-left-root-extreme").
std::string file_stem(const Failure& failure);

/// "missed (left root)", "late by 0.25 (right root)", "not asked".
std::string to_text(const Expected& expected, double late_by = 0);

/// How deep a miss or late hit of bodies is, or how far a false positive (beside_tolerance).
std::string wrong_by(const Judged& judged);

/// The result of an expectation.
enum class Change : std::uint8_t {
  kNone,
  kRegression,   ///< it is worse: what was correct is undecided or fails, what was undecided fails
  kImprovement,  ///< the other way
  kOther,        ///< it fails in another way, or what was correct is unknown
  kNotAsked,     ///< the method refuses what it took before, which says nothing of its answer
};
constexpr std::array<std::string_view, 5> names_of(Change) {
  return {"as expected", "regression", "improvement", "changed", "not asked"};
}
inline constexpr auto kAllChanges = all_of(Change{});

/// By the outcome, and by the cause where the expectation says one.
Change change_of(const Expected& expected, const Expected& got);

/// Pops of one search, when methods are asked about a find of another: TDIBM needs fewer on most.
inline constexpr std::uint64_t kEnoughPops = 2000;

/// Seconds of one query, so that none holds up the end of a command, or Ctrl-C, for longer. Pops
/// alone do not bound that: one of exact arithmetic on high degrees takes 50 ms. A method that is
/// served and looks at the clock (Deadline) ends long before that is a hang (kServedLimits).
inline constexpr double kLongestQuerySeconds = 5;
inline SearchOptions limited(SearchOptions search) {
  search.max_seconds = std::min(search.max_seconds, kLongestQuerySeconds);
  return search;
}

/// The `asked` of a case that failed in such a search. It allows more pops: what fails within few
/// does so with more.
Asked asked_with(const SearchOptions& search);

/// The cause that lost the contact of a case in the search of a method: loss_cause of its trace.
/// Empty where no contact by t_max is known, or the method cannot be traced.
std::string cause_of_loss(const std::string& method, const Case& value);

/// The field of an origin that says what an error was, where the query alone does not show it.
inline constexpr const char* kNote = "note";
/// What is wrong with a method of which Asker::differs is true.
inline constexpr const char* kAnswersDiffer = "answers differ from one ask to the next";

/// Asks methods about cases and says how they fail. For one thread.
class Asker {
 public:
  using CauseOfLoss = std::function<std::string(const std::string& method, const Case& value)>;

  /// cause: in place of cause_of_loss.
  explicit Asker(const SearchOptions& search, MethodSet methods = {},
                 CauseOfLoss cause = cause_of_loss)
      : search_(search), methods_(std::move(methods)), cause_(std::move(cause)) {}

  Judged ask(const std::string& method, const CheckedCase& known) {
    return ask(method, known, search_);
  }
  Judged ask(const std::string& method, const CheckedCase& known, const SearchOptions& search) {
    return ccdfuzz::ask(methods_[method], known, search);
  }

  /// What failed so, in no error, is asked again. The depth of a miss or late hit is measured, too
  /// (depth_of).
  Judged ask_how_deep(const Failure& failure, const CheckedCase& known);

  /// What an entry expects of a method that answered so about its case. It is the outcome with its
  /// cause: the name of an error, the kind of bodies, or what lost a contact.
  Expected expected(const std::string& method, const Case& value, const Judged& judged);

  /// How the method fails that answered so about a case; nothing where it does not.
  std::optional<Failure> failure(const std::string& method, const Case& value,
                                 const Judged& judged);
  /// What an entry expects of it, asked at the precision that the case says, and with no more pops
  /// than it says.
  Expected expected_as_asked(const std::string& method, const CheckedCase& known);

  /// Whether a plug-in that has just shown this shows something else when it is asked again, a few
  /// times. After a hang, which costs all of its time, it is not asked.
  bool differs(const std::string& method, const CheckedCase& known, const Expected& shown,
               const SearchOptions& search);

  /// Asks the methods that the find says nothing of yet, each with at most kEnoughPops, and makes
  /// the find expect what they do. What is undecided so is left out: a larger budget may decide it.
  void ask_others(Case& find, const std::vector<std::string>& methods);

  const SearchOptions& search() const { return search_; }
  MethodSet& methods() { return methods_; }

 private:
  SearchOptions search_;
  MethodSet methods_;
  CauseOfLoss cause_;
};

}  // namespace ccdfuzz
