#include "cli/replay_changes.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numeric>

#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "io/folder_lock.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

std::uint64_t Changes::total() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

std::string Changes::text() const {
  const bool is_all = total() > 0 && all_as_expected();
  std::string text = is_all ? "all as expected" : fmt::format("{} as expected", counts_[0]);
  constexpr std::array<const char*, kAllChanges.size()> kOne = {"", "regression", "improvement",
                                                                "other change", "not asked"},
                                                        kMany = {"", "regressions", "improvements",
                                                                 "other changes", "not asked"};
  for (size_t c = 1; c < counts_.size(); ++c) {
    if (counts_[c] > 0) text += ", " + counted(counts_[c], kOne[c], kMany[c]);
  }
  return text + (written_ > 0 ? "; " + counted(written_, "entry written", "entries written") : "");
}

void Changes::update(const std::string& path, const std::string& text,
                     const std::function<bool()>& is_unchanged) {
  const std::filesystem::path parent = std::filesystem::path(path).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  const FolderLock lock = need(FolderLock::take(folder));
  if (!is_unchanged()) {
    print_err(fmt::format("ccdfuzz: {}: changed meanwhile; it is left as it is\n", path));
    return;
  }
  need(write_file(path, text));
  ++written_;
}

std::vector<TableCell> change_cells(const std::string& of, std::string_view expected,
                                    std::string_view got, Change change) {
  return {{of},
          {std::string(expected)},
          {std::string(got), change != Change::kImprovement},
          {std::string(name_of(change))}};
}

}  // namespace ccdfuzz
