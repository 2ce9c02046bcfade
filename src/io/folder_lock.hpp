#pragma once

#include <string>
#include <utility>

#include "base/result.hpp"
#include "io/descriptor.hpp"

namespace ccdfuzz {

/// Keeps other threads and processes that lock the same folder waiting. The system drops the lock
/// when its holder dies, however it dies.
class FolderLock {
 public:
  /// Waits for the lock. Errors: the folder cannot be opened or locked, naming it. Where the file
  /// system has no locks, nobody waits, and stderr says so once.
  static Result<FolderLock> take(const std::string& folder);

  /// The folder that is locked. It stays open when the lock is released, so that the system gives
  /// its inode to no other folder, not even after it was removed.
  Descriptor folder() const;
  /// True iff this folder is the one that is locked.
  bool is_of(const Descriptor& folder) const;

 private:
  explicit FolderLock(Descriptor descriptor) : descriptor_(std::move(descriptor)) {}
  Descriptor descriptor_;
};

}  // namespace ccdfuzz
