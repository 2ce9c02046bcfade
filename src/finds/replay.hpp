#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_names.hpp"
#include "files/case_files.hpp"
#include "finds/asker.hpp"

namespace ccdfuzz {

/// The result of an expectation.
enum class Change : std::uint8_t {
  kNone,
  kRegression,   ///< it is worse: what was correct is undecided or fails, what was undecided fails
  kImprovement,  ///< the other way
  kOther,        ///< it fails in another way
};
constexpr std::array<std::string_view, 4> names_of(Change) {
  return {"as expected", "regression", "improvement", "changed"};
}
inline constexpr auto kAllChanges = all_of(Change{});

/// By the outcome, and by the cause where the expectation says one.
Change change_of(const Expected& expected, const Expected& got);

/// One expectation of an entry, asked again.
struct ReplayRow {
  std::string id;  ///< the entry's
  std::string method;
  Expected expected, got;
  Judged judged;

  Change change() const { return change_of(expected, got); }
};

/// "missed (left root)", "late by 0.25 (right root)".
std::string to_text(const Expected& expected, double late_by = 0);

/// Asks methods about entries. For one thread.
class Replayer {
 public:
  Replayer();

  /// Asks each method that something is expected of. One that is expected to end in an error is
  /// asked in another process, since it may end this one. Requires methods that make_method makes.
  std::vector<ReplayRow> replay(const std::string& id, const CheckedCase& known,
                                const std::map<std::string, Expected>& expected,
                                const SearchOptions& search);

 private:
  Asker here_, served_;
};

}  // namespace ccdfuzz
