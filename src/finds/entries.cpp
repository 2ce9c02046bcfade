#include "finds/entries.hpp"

#include <algorithm>
#include <filesystem>

#include "base/input_bytes.hpp"
#include "base/output_file.hpp"
#include "certify/checker/check_case.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

Result<std::vector<std::string>> list_entries(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (auto it = fs::recursive_directory_iterator(folder, error);
       !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
    std::error_code vanished;
    const bool hidden = it->path().filename().string().starts_with('.');
    if (hidden) it.disable_recursion_pending();
    if (hidden || it->path().extension() != ".json" || it->is_directory(vanished)) continue;
    paths.push_back(it->path().string());
    if (auto file = refuse_irregular(paths.back()); !file) return tl::unexpected(file.error());
  }
  if (error) return system_error(folder, "read", error.value());
  std::sort(paths.begin(), paths.end());
  return paths;
}

namespace {

Result<std::vector<NamedCase>> load_by(
    Result<std::vector<NamedCase>> (*read)(const std::string& path), const std::string& path) {
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_directory(path, ignored)) return read(path);
  const auto paths = list_entries(path);
  if (!paths) return tl::unexpected(paths.error());
  std::vector<NamedCase> entries;
  for (const std::string& entry : *paths) {
    auto cases = read(entry);
    // Taken away since it was listed; a link to nowhere is still there, and an error.
    if (!cases && fs::symlink_status(entry, ignored).type() == fs::file_type::not_found) continue;
    if (!cases) return cases;
    entries.push_back(std::move(cases->front()));
  }
  if (entries.empty()) return input_error(path, "the corpus is empty: no .json entry in it");
  return entries;
}

}  // namespace

Result<std::vector<NamedCase>> load_corpus(const std::string& path) {
  return load_by(read_checked_cases, path);
}

Result<std::vector<NamedCase>> load_unchecked_corpus(const std::string& path) {
  return load_by(read_cases, path);
}

}  // namespace ccdfuzz
