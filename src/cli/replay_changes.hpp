#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "finds/failure.hpp"
#include "io/table.hpp"

namespace ccdfuzz {

/// What became of expectations of one kind.
class Changes {
 public:
  void add(Change change) { ++counts_[static_cast<size_t>(change)]; }
  /// Writes an entry anew, in its locked folder. Where is_unchanged() is false it was changed since
  /// it was read, and is left so. Throws BadInput: of the file.
  void update(const std::string& path, const std::string& text,
              const std::function<bool()>& is_unchanged);

  std::uint64_t total() const;
  std::uint64_t count(Change change) const { return counts_[static_cast<size_t>(change)]; }
  bool all_as_expected() const { return count(Change::kNone) == total(); }
  /// "3 as expected, 1 regression; 1 entry written".
  std::string text() const;

 private:
  std::array<std::uint64_t, kAllChanges.size()> counts_{};
  std::uint64_t written_ = 0;
};

/// A row of the table: an expectation of a method or a property, and what was got.
std::vector<TableCell> change_cells(const std::string& of, std::string_view expected,
                                    std::string_view got, Change change);

}  // namespace ccdfuzz
