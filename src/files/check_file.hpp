#pragma once

#include <cstdint>
#include <string>

#include "case/checked_case.hpp"
#include "files/case_files.hpp"

namespace ccdfuzz {

/// As check_case, of a case from a file. Errors: naming its id, too.
Result<CheckedCase> check_case(const NamedCase& named);

/// The limit of this process for checking the cases of files, all together. So a file of many
/// costly cases cannot occupy a command for long. Work bounds each certificate alone.
class RunWork {
 public:
  /// The limit is kStart and the lesser of two: kEachCase per case so far, and kEachByte per byte
  /// of its files. kStart is one of the costliest certificates. The unit is operations on 64-bit
  /// words. Measured means per case: 6·10^6 in the paper's set, 23·10^6 after `prove`, 67·10^6 in
  /// the first 1,000 of FF (some 600 bytes each, compressed). Two tensor(8,8) take 88·10^6.
  static constexpr std::uint64_t kStart = std::uint64_t{1} << 32;
  static constexpr std::uint64_t kEachCase = std::uint64_t{1} << 27;
  static constexpr std::uint64_t kEachByte = std::uint64_t{1} << 18;

  /// Adds what checking the case took, by work_done_here() before and after. Called in the order of
  /// the cases by one thread at a time, so that the sum does not depend on threads. Among
  /// consecutive calls for one case the largest counts. Errors: past the limit, naming the case and
  /// the limit.
  static Result<void> add(const NamedCase& named, std::uint64_t work);
  /// Sets another limit, however many cases there are.
  static void allow(std::uint64_t most);
};

/// The next case; nothing at the end. Errors: as CaseStream, check_case and RunWork::add, naming
/// path and line.
Result<std::optional<NamedCase>> next_checked(CaseStream& cases);

/// The only case of a file. Errors: as read_case, check_case and RunWork::add.
Result<NamedCase> read_checked_case(const std::string& path);

}  // namespace ccdfuzz
