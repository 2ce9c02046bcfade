#include "io/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>

#include "io/output_file.hpp"

namespace ccdfuzz {

Result<FolderLock> FolderLock::take(const std::string& folder) {
  Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (*descriptor < 0) return system_error(folder, "open", errno);
  while (::flock(*descriptor, LOCK_EX) != 0) {
    if (errno != EINTR) return system_error(folder, "lock", errno);
  }
  return FolderLock(std::move(descriptor));
}

OpenFolder FolderLock::folder() const {
  // Not a duplicate of the descriptor, which would hold the lock.
  return OpenFolder(::openat(*descriptor_, ".", O_PATH | O_DIRECTORY | O_CLOEXEC));
}

std::pair<dev_t, ino_t> OpenFolder::inode() const {
  struct stat info {};
  if (::fstat(*descriptor_, &info) != 0) return {};
  return {info.st_dev, info.st_ino};
}

bool OpenFolder::operator==(const OpenFolder& other) const {
  return inode() == other.inode();
}

}  // namespace ccdfuzz
