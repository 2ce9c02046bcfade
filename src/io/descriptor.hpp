#pragma once

#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <utility>

namespace ccdfuzz {

/// A file descriptor that is closed with this; or none, −1.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

  int operator*() const { return number_; }

 private:
  int number_;
};

/// Whether this error of a lock says that there are none: some file systems of clusters know none.
/// There it is for the user to run one at a time.
inline bool is_without_locks(int error) {
  return error == ENOSYS || error == EOPNOTSUPP || error == ENOLCK;
}

/// Writes all of the bytes. Returns 0, or the errno of the error that ended it.
inline int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace ccdfuzz
