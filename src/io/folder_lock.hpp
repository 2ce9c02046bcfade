#pragma once

#include <sys/types.h>

#include <string>
#include <utility>

#include "base/result.hpp"
#include "io/descriptor.hpp"

namespace ccdfuzz {

/// A folder that is kept open, so that the system gives its inode to no other folder, not even
/// after it was removed.
class OpenFolder {
 public:
  OpenFolder() = default;
  explicit OpenFolder(int descriptor) : descriptor_(descriptor) {}

  /// True iff both are the same folder.
  bool operator==(const OpenFolder& other) const;

 private:
  std::pair<dev_t, ino_t> inode() const;

  Descriptor descriptor_;
};

/// Keeps other threads and processes that lock the same folder waiting. The system drops the lock
/// when its holder dies, however it dies.
class FolderLock {
 public:
  /// Waits for the lock. Errors: the folder cannot be opened or locked, naming it.
  static Result<FolderLock> take(const std::string& folder);

  /// The folder that is locked. Stays open when the lock is released.
  OpenFolder folder() const;

 private:
  explicit FolderLock(Descriptor descriptor) : descriptor_(std::move(descriptor)) {}
  Descriptor descriptor_;
};

}  // namespace ccdfuzz
