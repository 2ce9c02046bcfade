#pragma once

#include <string>
#include <utility>

#include "numeric/result.hpp"

namespace ccdfuzz {

/// Keeps other threads and processes that lock the same folder waiting. The system drops the lock
/// when its holder dies, however it dies.
class FolderLock {
 public:
  /// Waits for the lock. Errors: the folder cannot be opened or locked, naming it.
  static Result<FolderLock> take(const std::string& folder);
  FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace ccdfuzz
