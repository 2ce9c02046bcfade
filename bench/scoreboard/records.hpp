#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "fault_list.hpp"
#include "io/fields.hpp"
#include "io/run_file.hpp"

namespace ccdfuzz {

/// In place of a fault: a run on the sources as they are.
inline constexpr const char* kNoFault = "none";
/// In place of a fault: a run of the right sources with all faults watched.
inline constexpr const char* kWatchedFaults = "watched";

/// What one run of a driver against one fault gave.
struct Record {
  std::string driver, fault;  ///< fault: its name, or kNoFault, or kWatchedFaults
  std::uint64_t seed = 0;     ///< from 1
  double limit = 0;           ///< CPU seconds
  std::uint64_t reached = 0, triggered = 0, executions = 0;
  bool detected = false;
  /// No run of its own: the fault's wrong value never differed in a run of the right sources with
  /// this seed and as many executions.
  bool watched = false;
  double seconds = 0;  ///< CPU, until it was detected or the limit
  std::string found;   ///< its first line
  /// definition_hash of the fault that it was, or of all that were watched; empty: not known, or no
  /// fault.
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

/// The records of a campaign, kept in a file of a JSON object a line. Those of a campaign that goes
/// on are in a journal beside it, so that an interrupted one resumes where it was.
class Records {
 public:
  enum class Use : std::uint8_t {
    kRead,    ///< the file or its journal must be there; nothing is written
    kExtend,  ///< both are begun where they are not
  };

  /// Reads what file and journal have; no path: begins with nothing, and keeps it in memory. A last
  /// line that is unfinished is left out. Errors: a line that is no record (parse_record); the file
  /// or its folder cannot be written to; another campaign is at it.
  static Result<Records> open(const std::string& path, const std::vector<PlantedFault>& faults,
                              Use use);

  /// The record of a run with at least this limit, if there is one.
  const Record* find(const std::string& driver, const std::string& fault, std::uint64_t seed,
                     double limit) const;
  /// Adds a record, in the journal too.
  Result<void> add(Record record);
  /// Puts the journal's records into the file.
  Result<void> finish();

  using Key = std::tuple<std::string, std::string, std::uint64_t>;
  const std::map<Key, Record>& all() const { return records_; }
  /// How many runs are not among all() because their fault was another by the same name.
  std::size_t outdated() const;

 private:
  explicit Records(const std::vector<PlantedFault>& faults);
  Result<void> read_file();
  /// What the journal has, which may have been begun for that.
  Result<std::vector<std::string>> begin_journal();
  Result<void> take_lines(const std::vector<std::string>& journal);
  void take(const Record& record);

  std::string path_;
  const std::vector<PlantedFault>* faults_;
  std::map<std::string, std::string> definitions_;  ///< by what Record::fault may name
  std::map<Key, Record> records_;
  std::set<Key> outdated_;
  std::set<std::string, std::less<>> lines_;  ///< those of the file
  std::optional<RunFile> journal_;
  std::string added_;  ///< the lines that are in the journal only
};

}  // namespace ccdfuzz
