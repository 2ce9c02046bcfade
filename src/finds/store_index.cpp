#include "finds/store_index.hpp"

#include <sys/stat.h>

#include <filesystem>

#include "certify/checker/check_case.hpp"
#include "finds/entries.hpp"
#include "finds/store.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

namespace {

bool looks_like_an_address(const std::string& stem) {
  return stem.size() == 32 && stem.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

Result<void> StoreIndex::refresh(const std::string& folder, const std::string& home) {
  const auto paths = list_entries(folder);
  if (!paths) return tl::unexpected(paths.error());
  std::map<std::string, Entry> now;
  for (const std::string& path : *paths) {
    struct stat info {};
    if (::stat(path.c_str(), &info) != 0) continue;  // removed by hand a moment ago
    // A file is only ever replaced by another one, so that these tell versions apart.
    const std::tuple stamp(info.st_ino, info.st_size, info.st_mtim.tv_sec, info.st_mtim.tv_nsec);
    const auto known = entries_.find(path);
    if (known != entries_.end() && known->second.stamp_ == stamp) {
      now.insert(entries_.extract(known));
      continue;
    }
    auto cases = read_checked_cases(path);
    if (!cases) {
      *this = {};
      return tl::unexpected(cases.error());
    }
    Entry entry;
    entry.value = std::move(cases->front().value);
    entry.rank = {size_of(entry.value.query), content_address(entry.value.query)};
    const std::string stem = fs::path(path).stem();
    if (looks_like_an_address(stem) && stem != entry.rank.second) {
      return input_error(path, "is named by the address of another query; give it its own, " +
                                   entry.rank.second + ", or any other name");
    }
    entry.fixed =
        fs::path(path).stem() != entry.rank.second || fs::path(path).parent_path() != home;
    entry.stamp_ = stamp;
    now.emplace(path, std::move(entry));
  }
  entries_ = std::move(now);

  by_address_.clear();
  holders_.clear();
  for (const auto& [path, entry] : entries_) {
    std::string& at = by_address_[entry.rank.second];
    if (at.empty() || entry.fixed) at = path;
    for (const FailureKey& key : failures_of(entry.value)) holders_[key][entry.rank] = path;
  }
  return {};
}

const std::string* StoreIndex::find(const std::string& address) const {
  const auto at = by_address_.find(address);
  return at == by_address_.end() ? nullptr : &at->second;
}

const Rank* StoreIndex::smallest(const FailureKey& key, const std::string& except) const {
  const auto at = holders_.find(key);
  if (at == holders_.end()) return nullptr;
  for (const auto& [rank, path] : at->second) {
    if (rank.second != except) return &rank;
  }
  return nullptr;
}

std::vector<std::string> StoreIndex::holders(const FailureKey& key) const {
  std::vector<std::string> paths;
  if (const auto at = holders_.find(key); at != holders_.end()) {
    for (const auto& [rank, path] : at->second) paths.push_back(path);
  }
  return paths;
}

std::vector<FailureKey> StoreIndex::held_twice() const {
  std::vector<FailureKey> keys;
  for (const auto& [key, holders] : holders_) {
    if (holders.size() > 1) keys.push_back(key);
  }
  return keys;
}

}  // namespace ccdfuzz
