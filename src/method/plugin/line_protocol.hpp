#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/enum_names.hpp"
#include "case/judge.hpp"
#include "ccd/search.hpp"
#include "io/child.hpp"
#include "method/domain.hpp"
#include "method/features.hpp"
#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

/// The unit of a claimed tolerance.
enum class ToleranceKind : std::uint8_t { kTime, kTimeRelative, kSpace, kSpaceRelative };
constexpr std::array<std::string_view, 4> names_of(ToleranceKind) {
  return {"time", "time_relative", "space", "space_relative"};
}

/// What it says to a query that is not finite; undefined: anything, so that it is not asked.
enum class NanPolicy : std::uint8_t { kUndefined, kError, kInconclusive, kHit, kRefused };
constexpr std::array<std::string_view, 5> names_of(NanPolicy) {
  return {"undefined", "error", "inconclusive", "hit", "refused"};
}

/// The largest tolerance, in time or space, and minimum separation that may be claimed. Hunts at
/// ordinary scales draw lengths up to 2^40, so with more any hit would be right there.
inline constexpr double kMostTolerance = 0x1p40;
/// The same of a tolerance relative to t_max or to the largest coordinate. With a whole t_max every
/// time is near enough, and with 2·√3 coordinates every two points are.
inline constexpr double kMostRelativeTolerance = 1;

/// What a plug-in says of itself.
struct PluginDescription {
  std::string name;
  std::string version;
  std::string line;  ///< all of it, as it was said
  Domain domain;
  std::string promise;  ///< the sentence that it is held to, and where it stands
  bool conservative = false;
  bool closed_t_max = true;
  bool contact_at_zero = true;
  ToleranceKind tolerance_kind = ToleranceKind::kTime;
  double tolerance = 0;
  double minimum_separation = 0;
  NanPolicy nan_policy = NanPolicy::kUndefined;
  Features features;
};

/// The limits of a question. has_work: with max_work, which is of our own methods.
void limit_fields(auto& archive, auto& options, bool has_work = true) {
  archive.when(true, "precision", options.precision);
  archive.when(true, "max_iterations", options.max_pops);
  archive.when(true, "max_seconds", options.max_seconds);
  archive.when(true, "max_bytes", options.max_bytes);
  archive.when(has_work, "max_work", options.max_work);
}

/// The line protocol: one JSON object a line each way; docs/plug-ins.md has it in words.
std::string describe_request(const std::string& options);
/// Coordinates that are not finite become the words "nan", "inf" and "-inf". has_work: as above.
std::string query_request(const Query& query, const SearchOptions& options, std::uint64_t id,
                          bool has_work);

/// The fault of a plug-in that cannot be used at all: it is the user who must act.
inline constexpr const char* kRefusal = "refused";
/// The same, said by who was to run it: its file is not there, or is none of this version.
inline constexpr const char* kAway = "away";
/// Errors: kRefusal (it says so, or claims a tolerance above those limits), kAway, or anything that
/// is not a description.
tl::expected<PluginDescription, Fault> read_description(const std::string& line);
/// The fields in which two descriptions differ, with what each says: "version (\"1\", then
/// \"2\")". Empty: none. Requires lines that read_description takes.
std::string changes_between(const std::string& before, const std::string& after);

/// "hit", "miss", "inconclusive" or "refused".
constexpr std::string_view word_of(Verdict verdict) {
  return verdict == Verdict::kUndecided ? "inconclusive" : name_of(verdict);
}

/// An answer, as far as it goes beyond Answer.
struct PluginAnswer {
  Answer answer;  ///< toi is the lower bound
  double toi_upper = std::numeric_limits<double>::quiet_NaN();
  double tolerance = std::numeric_limits<double>::quiet_NaN();  ///< achieved
  bool has_seconds = false;

  /// Says the same, whatever it cost.
  bool agrees_with(const PluginAnswer& other) const;
};

/// Reads the answer to a query about [0, t_max]. Errors: whatever is no answer, each by its name.
/// They are "garbage", "stale" (of another question), "toi NaN", "toi infinite", "toi outside",
/// "toi missing", "uv NaN" and "error" (it says so). The names of worker.cpp are, too.
tl::expected<PluginAnswer, Fault> read_answer(const std::string& line, std::uint64_t id,
                                              double t_max);

}  // namespace ccdfuzz
