#include "hunt/shared_choices.hpp"

#include <sys/mman.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <new>
#include <system_error>

#include "properties/choices.hpp"

namespace ccdfuzz {

struct SharedChoices::Memory {
  struct Made {
    std::uint64_t choice;
    std::uint64_t width;
  };
  std::atomic<std::size_t> size;  ///< grows after what it counts is there, whenever the copy ends
  std::array<Made, kMost> made;
};

SharedChoices::SharedChoices() {
  void* const memory = ::mmap(nullptr, sizeof(Memory), PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) {
    throw std::system_error(errno, std::generic_category(), "cannot share memory with a process");
  }
  static_assert(std::atomic<std::size_t>::is_always_lock_free);
  memory_ = new (memory) Memory;  // which begins without choices
}

SharedChoices::~SharedChoices() {
  ::munmap(memory_, sizeof(Memory));
}

void SharedChoices::clear() {
  memory_->size = 0;
}

void SharedChoices::add(std::uint64_t choice, int width) {
  const std::size_t size = memory_->size;
  if (size == kMost) return;
  memory_->made[size] = {choice, static_cast<std::uint64_t>(width)};
  memory_->size = size + 1;
}

std::vector<std::uint64_t> SharedChoices::numbers() const {
  std::vector<std::uint64_t> numbers;
  for (std::size_t i = 0; i < memory_->size; ++i) numbers.push_back(memory_->made[i].choice);
  return numbers;
}

std::vector<std::uint8_t> SharedChoices::bytes() const {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < memory_->size; ++i) {
    append_choice(bytes, memory_->made[i].choice, static_cast<int>(memory_->made[i].width));
  }
  return bytes;
}

}  // namespace ccdfuzz
