#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "numeric/result.hpp"

namespace ccdfuzz {

/// Stands for the fault of a run on the sources as they are.
inline constexpr const char* kNoFault = "none";
/// Stands for a run of the right sources with all faults watched.
inline constexpr const char* kWatchedFaults = "watched";

/// What one run of a driver against one fault gave.
struct Record {
  std::string driver, fault;  ///< fault: its name, or kNoFault
  std::uint64_t seed = 0;
  double limit = 0;  ///< CPU seconds
  std::uint64_t reached = 0, triggered = 0, executions = 0;
  bool detected = false;
  /// No run of its own: the fault's wrong value never differed in a run of the right sources with
  /// this seed and as many executions.
  bool watched = false;
  double seconds = 0;  ///< CPU, until it was detected or the limit
  std::string found;   ///< its first line
};

/// The records of a campaign, kept in a file of a JSON object a line, so that a campaign that is
/// interrupted goes on where it was.
class Records {
 public:
  /// Reads what the file has, if there is one. Errors: a line that is no record.
  static Result<Records> open(const std::string& path);

  /// The record of a run with at least this limit, if there is one.
  const Record* find(const std::string& driver, const std::string& fault, std::uint64_t seed,
                     double limit) const;
  /// Adds a record, in the file too.
  Result<void> add(const Record& record);

  using Key = std::tuple<std::string, std::string, std::uint64_t>;
  const std::map<Key, Record>& all() const { return records_; }

 private:
  std::string path_;
  std::map<Key, Record> records_;
};

}  // namespace ccdfuzz
