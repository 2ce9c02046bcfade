#pragma once

#include <sys/types.h>

#include <string>
#include <utility>

#include "base/result.hpp"

namespace ccdfuzz {

/// A folder that is kept open, so that the system gives its inode to no other folder, not even
/// after it was removed.
class OpenFolder {
 public:
  OpenFolder() = default;
  explicit OpenFolder(int descriptor) : descriptor_(descriptor) {}
  OpenFolder(OpenFolder&& other) noexcept { *this = std::move(other); }
  OpenFolder& operator=(OpenFolder&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~OpenFolder();

  /// True iff both are the same folder.
  bool operator==(const OpenFolder& other) const;

 private:
  std::pair<dev_t, ino_t> inode() const;

  int descriptor_ = -1;
};

/// Keeps other threads and processes that lock the same folder waiting. The system drops the lock
/// when its holder dies, however it dies.
class FolderLock {
 public:
  /// Waits for the lock. Errors: the folder cannot be opened or locked, naming it.
  static Result<FolderLock> take(const std::string& folder);
  FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

  /// The folder that is locked. Stays open when the lock is released.
  OpenFolder folder() const;

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace ccdfuzz
