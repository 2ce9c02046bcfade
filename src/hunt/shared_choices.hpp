#pragma once

#include <cstdint>
#include <vector>

namespace ccdfuzz {

/// The choices that a copy of this process made, which outlive its crash: in memory that both have.
class SharedChoices {
 public:
  /// Errors: throws std::system_error where the system refuses memory.
  SharedChoices();
  ~SharedChoices();
  SharedChoices(const SharedChoices&) = delete;
  SharedChoices& operator=(const SharedChoices&) = delete;

  void clear();
  /// One more choice, of so many bytes (ChoiceSource::Watch). More than kMost are not kept.
  void add(std::uint64_t choice, int width);

  /// For StoredChoices and ByteChoices.
  std::vector<std::uint64_t> numbers() const;
  std::vector<std::uint8_t> bytes() const;

  /// The largest inputs of fuzz targets have so many bytes, and a choice takes one at least; what
  /// draws make has thousands. Pages that nobody touches cost nothing.
  static constexpr std::size_t kMost = std::size_t{1} << 20;

 private:
  struct Memory;
  Memory* memory_;
};

}  // namespace ccdfuzz
