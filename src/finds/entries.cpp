#include "finds/entries.hpp"

#include <filesystem>

#include "files/check_file.hpp"
#include "io/input_bytes.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

Result<std::vector<std::string>> list_entries(const std::string& folder) {
  CCDFUZZ_TRY(auto paths, files_under(folder, [](const std::string& name) {
                return name.starts_with('.') || name == kClaims;
              }));
  std::erase_if(paths, [](const std::string& path) {
    std::error_code vanished;
    return fs::path(path).extension() != ".json" || fs::is_directory(path, vanished);
  });
  for (const std::string& path : paths) CCDFUZZ_TRY_VOID(refuse_irregular(path));
  return paths;
}

Result<std::vector<std::string>> corpus_files(const std::string& path) {
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_directory(path, ignored)) return std::vector{path};
  Result<std::vector<std::string>> files = list_entries(path);
  if (files && files->empty()) {
    return input_error(path, "the corpus is empty: no .json entry in it");
  }
  return files;
}

Result<void> for_each_entry(const std::string& folder,
                            const std::function<void(const NamedCase&)>& visit) {
  CCDFUZZ_TRY(const auto paths, list_entries(folder));
  for (const std::string& path : paths) {
    const auto entry = read_checked_case(path);
    // Taken away since it was listed; a link to nowhere is still there, and an error.
    std::error_code ignored;
    if (!entry && fs::symlink_status(path, ignored).type() == fs::file_type::not_found) continue;
    if (!entry) return tl::unexpected(entry.error());
    visit(*entry);
  }
  return {};
}

}  // namespace ccdfuzz
