#include "finds/entries.hpp"

#include <algorithm>
#include <filesystem>

#include "files/check_file.hpp"
#include "io/input_bytes.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

Result<std::vector<std::string>> list_entries(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (auto it = fs::recursive_directory_iterator(folder, error);
       !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
    std::error_code vanished;
    const std::string name = it->path().filename().string();
    const bool hidden = name.starts_with('.') || name == kClaims;
    if (hidden) it.disable_recursion_pending();
    if (hidden || it->path().extension() != ".json" || it->is_directory(vanished)) continue;
    paths.push_back(it->path().string());
    CCDFUZZ_TRY_VOID(refuse_irregular(paths.back()));
  }
  if (error) return system_error(folder, "read", error.value());
  std::sort(paths.begin(), paths.end());
  return paths;
}

namespace {

Result<void> for_each_case(const std::vector<std::string>& paths,
                           const std::function<void(const NamedCase&)>& visit) {
  for (const std::string& path : paths) {
    const auto cases = read_checked_cases(path);
    // Taken away since it was listed; a link to nowhere is still there, and an error.
    std::error_code ignored;
    if (!cases && fs::symlink_status(path, ignored).type() == fs::file_type::not_found) continue;
    if (!cases) return tl::unexpected(cases.error());
    std::ranges::for_each(*cases, visit);
  }
  return {};
}

}  // namespace

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
  return list_entries(folder).and_then(
      [&](const std::vector<std::string>& paths) { return for_each_case(paths, visit); });
}

Result<std::vector<NamedCase>> load_corpus(const std::string& path) {
  std::vector<NamedCase> entries;
  return corpus_files(path)
      .and_then([&](const std::vector<std::string>& files) {
        return for_each_case(files, [&](const NamedCase& entry) { entries.push_back(entry); });
      })
      .map([&] { return std::move(entries); });
}

}  // namespace ccdfuzz
