#include "io/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <mutex>
#include <system_error>

#include "base/text.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

Result<FolderLock> FolderLock::take(const std::string& folder) {
  Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (*descriptor < 0) return system_error(folder, "open", errno);
  while (::flock(*descriptor, LOCK_EX) != 0) {
    if (is_without_locks(errno)) {
      static std::once_flag said;
      std::call_once(said, [&] {
        fmt::print(stderr,
                   "ccdfuzz: {}: cannot be locked ({}): let one command at a time write there\n",
                   shown_line(folder), std::generic_category().message(errno));
      });
      break;
    }
    if (errno != EINTR) return system_error(folder, "lock", errno);
  }
  return FolderLock(std::move(descriptor));
}

Descriptor FolderLock::folder() const {
  // Not a duplicate of the descriptor, which would hold the lock.
  return Descriptor(::openat(*descriptor_, ".", O_PATH | O_DIRECTORY | O_CLOEXEC));
}

bool FolderLock::is_of(const Descriptor& folder) const {
  using Status = struct stat;
  Status locked{}, other{};
  return ::fstat(*descriptor_, &locked) == 0 && ::fstat(*folder, &other) == 0 &&
         locked.st_dev == other.st_dev && locked.st_ino == other.st_ino;
}

}  // namespace ccdfuzz
