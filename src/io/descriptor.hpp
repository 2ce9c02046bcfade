#pragma once

#include <unistd.h>

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

}  // namespace ccdfuzz
