#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "drivers.hpp"
#include "fault_list.hpp"
#include "io/fields.hpp"
#include "io/run_file.hpp"

namespace ccdfuzz {

/// In place of a fault: a run on the sources as they are.
inline constexpr const char* kNoFault = "none";
/// In place of a fault: a run of the right sources with all faults watched.
inline constexpr const char* kWatchedFaults = "watched";

/// Eight hex digits that change with what a fault is: its file, the right text and the wrong one.
std::string definition_hash(const PlantedFault& fault);

/// What one run of a driver against one fault gave.
struct Record {
  Driver driver = {};
  std::string fault;       ///< its name, or kNoFault, or kWatchedFaults
  std::uint64_t seed = 0;  ///< from 1
  double limit = 0;        ///< CPU seconds
  std::uint64_t reached = 0, triggered = 0, executions = 0;
  bool detected = false;
  /// No run of its own: the fault's wrong value never differed in a run of the right sources with
  /// this seed and as many executions.
  bool watched = false;
  double seconds = 0;  ///< CPU, until it was detected or the limit
  std::string found;   ///< its first line
  /// definition_hash of the fault that it was, or a hash of all that were watched; empty: not
  /// known, or no fault.
  std::string definition;

  static void fields(auto& archive, auto& record) {
    archive("driver", record.driver);
    archive("fault", record.fault);
    archive("seed", record.seed);
    archive("limit", record.limit, positive);
    archive("reached", record.reached);
    archive("triggered", record.triggered);
    archive("detected", record.detected);
    archive("executions", record.executions);
    archive("seconds", record.seconds, not_negative);
    archive("found", record.found);
    archive("watched", record.watched);
    archive.optional("definition", record.definition);
  }
};

/// The records of campaigns, kept in a run file: one that was interrupted resumes where it was.
class Records {
 public:
  enum class Use : std::uint8_t {
    kRead,    ///< the file must be there; nothing is written
    kExtend,  ///< it is begun where it is not
  };

  /// Reads what the file has; no path: begins with nothing, and keeps it in memory. Errors, naming
  /// line, field and value: a line is no record of a driver and one of the faults. Those of RunFile
  /// and RunLines.
  static Result<Records> open(const std::string& path, const std::vector<PlantedFault>& faults,
                              Use use);

  /// The record of a run with at least this limit, if there is one.
  const Record* find(Driver driver, const std::string& fault, std::uint64_t seed,
                     double limit) const;
  /// Adds a record, in the file too.
  Result<void> add(Record record);

  using Key = std::tuple<Driver, std::string, std::uint64_t>;
  const std::map<Key, Record>& all() const { return records_; }
  /// How many runs are not among all() because their fault was another by the same name.
  std::size_t outdated() const;

 private:
  explicit Records(const std::vector<PlantedFault>& faults);
  void take(const Record& record);

  std::map<std::string, std::string> definitions_;  ///< by what Record::fault may name
  std::map<Key, Record> records_;
  std::set<Key> outdated_;
  std::optional<RunFile> file_;
};

}  // namespace ccdfuzz
