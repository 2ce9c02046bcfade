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

using Read = Result<std::vector<NamedCase>> (*)(const std::string& path);

Result<void> for_each_entry(const std::string& folder, Read read,
                            const std::function<void(const NamedCase&)>& visit) {
  const auto paths = list_entries(folder);
  if (!paths) return tl::unexpected(paths.error());
  for (const std::string& path : *paths) {
    const auto cases = read(path);
    // Taken away since it was listed; a link to nowhere is still there, and an error.
    std::error_code ignored;
    if (!cases && fs::symlink_status(path, ignored).type() == fs::file_type::not_found) continue;
    if (!cases) return tl::unexpected(cases.error());
    visit(cases->front());
  }
  return {};
}

Result<std::vector<NamedCase>> load_by(Read read, const std::string& path) {
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_directory(path, ignored)) return read(path);
  std::vector<NamedCase> entries;
  const auto all =
      for_each_entry(path, read, [&](const NamedCase& entry) { entries.push_back(entry); });
  if (!all) return tl::unexpected(all.error());
  if (entries.empty()) return input_error(path, "the corpus is empty: no .json entry in it");
  return entries;
}

}  // namespace

Result<void> for_each_entry(const std::string& folder,
                            const std::function<void(const NamedCase&)>& visit) {
  return for_each_entry(folder, read_checked_cases, visit);
}

Result<std::vector<NamedCase>> load_corpus(const std::string& path) {
  return load_by(read_checked_cases, path);
}

Result<std::vector<NamedCase>> load_unchecked_corpus(const std::string& path) {
  return load_by(read_cases, path);
}

}  // namespace ccdfuzz
