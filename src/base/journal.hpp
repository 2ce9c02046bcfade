#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.hpp"

namespace ccdfuzz {

/// What a long run has done so far: records in a file that is only appended to. A run that is
/// killed at any moment, and begun again, finds all records that were whole, in their order, and
/// goes on behind them.
///
/// The file: a line that says what it is, then frames, the first of which is the header. A frame is
/// the length of its bytes and their XXH3-64, each as 8 bytes, least first, and the bytes. Whatever
/// follows the last sound frame was being written when the run ended, and is cut off.
class Journal {
 public:
  /// What the run was asked for: names and values, all of which must be the same to go on.
  using Header = std::vector<std::pair<std::string, std::string>>;

  /// Where the journal of a run stands whose result goes to `output`.
  static std::string path_for(const std::string& output) { return output + ".partial"; }

  /// Goes on with the journal at path, or begins it where there is none. Errors: it belongs to a
  /// run that was asked for something else, naming what; another process goes on with it (where
  /// the file system has locks); it is something else; what the system says. What stands there then
  /// stays.
  static Result<Journal> open(const std::string& path, const Header& header);
  /// The records that stand in the journal at path, which may be of a run that goes on; nothing is
  /// written or locked. Errors: as of open, but for those of writing.
  static Result<std::vector<std::string>> read(const std::string& path, const Header& header);
  Journal(Journal&& other) noexcept;
  Journal& operator=(Journal&&) = delete;
  ~Journal();

  /// How many records there are.
  std::uint64_t size() const { return size_; }

  /// Errors: what the system says, naming the path. No appending after an error.
  Result<void> append(std::string_view record);

  /// Calls visit on all records in order, until it gives an error.
  Result<void> for_each(const std::function<Result<void>(std::string_view)>& visit) const;

  /// The run is over and what it made stands elsewhere: takes the journal away.
  Result<void> remove();

 private:
  Journal(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}
  Result<void> begin(const Header& header);
  Result<void> resume(const Header& header);

  std::string path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t first_record_ = 0;  ///< its offset
};

}  // namespace ccdfuzz
