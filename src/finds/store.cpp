#include "finds/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <mutex>

#include "base/verify.hpp"
#include "certify/checker/check_truth.hpp"
#include "files/case_json.hpp"
#include "files/check_file.hpp"
#include "files/tree_file.hpp"
#include "io/folder_lock.hpp"
#include "io/input_bytes.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

namespace {

/// Not one that is hidden, or would lie in another folder.
Result<void> check_name(const std::string& name) {
  const bool is_plain = name.find_first_of(std::string_view("/\0", 2)) == std::string::npos;
  if (is_plain && !name.empty() && !name.starts_with('.')) return {};
  return input_error("", fmt::format("\"{}\" is not a file name: it is empty, begins with '.' or "
                                     "has a '/' or a zero byte in it",
                                     name));
}

bool has_tree(const Case& value) {
  return value.truth.clearance && std::holds_alternative<MissTree>(*value.truth.clearance);
}

bool shows(const Case& value, const Failure& failure) {
  const std::vector<Failure> shown = failures_of(value);
  return std::ranges::find(shown, failure) != shown.end();
}

/// Removes an entry and then its tree, so that no entry names one that is not there.
Result<void> remove_entry(const std::string& path) {
  std::error_code error;
  fs::remove(path, error);
  if (!error) fs::remove(trees_path(path), error);
  if (error) return system_error(path, "remove", error.value());
  return {};
}

/// Writes the tree and then the entry. trees: where the tree is now.
Result<void> write_entry(const std::string& path, Case value, const std::string& trees) {
  return carry_tree(value.truth, trees, path).and_then([&] {
    return write_file(path, to_json(value, JsonLayout::kReadable) + "\n");
  });
}

/// Makes an entry say what a united one does. The name of a tree follows from that of its entry:
/// both cannot be replaced at one moment, so that in between the entry has none.
Result<Store::Put> rewrite_entry(const NamedCase& old, United united) {
  const std::string& path = old.id;
  Case& value = united.value;
  if (value == old.value) return Store::Put::kKnown;
  const auto write = [&](const Case& now) {
    return write_file(path, to_json(now, JsonLayout::kReadable) + "\n");
  };
  const bool has_other_tree = has_tree(value) && value.truth.clearance != old.value.truth.clearance;
  const bool loses_tree = has_tree(old.value) && !has_tree(value);
  Result<void> written;
  if (has_other_tree && has_tree(old.value)) {
    Case bare = old.value;
    drop_tree(bare.truth);
    written = write(bare);
  }
  if (written && has_other_tree) written = carry_tree(value.truth, united.trees, path);
  if (written) written = write(value);
  std::error_code error;
  if (written && loses_tree) fs::remove(trees_path(path), error);
  if (error) return system_error(trees_path(path), "remove", error.value());
  return written.map([] { return Store::Put::kMerged; });
}

}  // namespace

std::optional<Failure> named_by_failure(const NamedCase& entry) {
  const std::string stem = fs::path(entry.id).stem();
  for (const Failure& failure : failures_of(entry.value)) {
    if (file_stem(failure) == stem) return failure;
  }
  return std::nullopt;
}

struct Store::State {
  /// The smallest entry of a name of its own that shows a failure.
  struct Named {
    Rank rank;
    std::string path;
  };

  std::string folder;
  std::string home;  ///< where entries are written; locked while that is done
  std::mutex mutex;
  OpenFolder home_folder;
  std::uint64_t times_replaced = 0;
  std::map<Failure, Named> named;

  Result<FolderLock> enter();
  /// The result of work(), one at a time, in the locked folder.
  template <class Work>
  auto locked(const Work& work) -> decltype(work()) {
    const std::lock_guard one_at_a_time(mutex);
    CCDFUZZ_TRY(const auto lock, enter());
    return work();
  }
  Result<void> read_named();
  void note_named(const NamedCase& entry);
  std::string path_of(const Failure& failure) const {
    return fmt::format("{}/{}.json", home, file_stem(failure));
  }
  Result<std::optional<std::string>> move_aside(const NamedCase& entry) const;
  Result<Put> put(const Failure& failure, const Case& find, const std::string& trees,
                  const AskAgain& again);
};

namespace {

/// The entry of a file; nothing where there is no file. Errors: as read_checked_cases.
Result<std::optional<NamedCase>> entry_at(const std::string& path) {
  std::error_code error;
  if (fs::symlink_status(path, error).type() == fs::file_type::not_found) return std::nullopt;
  return refuse_irregular(path)
      .and_then([&] { return read_checked_cases(path); })
      .map([](std::vector<NamedCase> cases) { return std::optional(std::move(cases.front())); });
}

}  // namespace

/// Locks the folder, which is made again if it was removed.
Result<FolderLock> Store::State::enter() {
  CCDFUZZ_TRY_VOID(make_folder(home));
  CCDFUZZ_TRY(auto lock, FolderLock::take(home));
  if (OpenFolder now = lock.folder(); !(now == home_folder)) {
    home_folder = std::move(now);
    ++times_replaced;
    CCDFUZZ_TRY_VOID(read_named());
  }
  return lock;
}

Result<void> Store::State::read_named() {
  named.clear();
  return for_each_entry(folder, [&](const NamedCase& entry) {
    if (fs::path(entry.id).parent_path() != home || !named_by_failure(entry)) note_named(entry);
  });
}

void Store::State::note_named(const NamedCase& entry) {
  Named now{rank_of(entry.value.query), entry.id};
  for (const Failure& failure : failures_of(entry.value)) {
    const auto [known, is_first] = named.try_emplace(failure, now);
    if (!is_first && now.rank < known->second.rank) known->second = now;
  }
}

/// Gives an entry its address as its name. If its query is there already, that entry stays
/// and says of it what both do. Returns its new path, or nothing if it was there.
Result<std::optional<std::string>> Store::State::move_aside(const NamedCase& entry) const {
  const std::string aside = fmt::format("{}/{}.json", home, content_address(entry.value.query));
  CCDFUZZ_TRY(const auto standing, entry_at(aside));
  const Result<void> kept =
      standing
          ? rewrite_entry(*standing, unite(*standing, entry.value, trees_path(entry.id), nullptr))
                .map([](Put) {})
          : write_entry(aside, entry.value, trees_path(entry.id));
  return kept.and_then([&] { return remove_entry(entry.id); }).map([&] {
    return standing ? std::nullopt : std::optional(aside);
  });
}

Result<Store::Put> Store::State::put(const Failure& failure, const Case& find,
                                     const std::string& trees, const AskAgain& again) {
  const std::string path = path_of(failure);
  const Rank rank = rank_of(find.query);
  if (const auto known = named.find(failure);
      known != named.end() && !(rank < known->second.rank)) {
    if (!again || known->second.rank < rank) return Put::kKnown;
    CCDFUZZ_TRY(const auto twin, entry_at(known->second.path));
    if (twin) return rewrite_entry(*twin, unite(*twin, find, trees, again));
  }
  CCDFUZZ_TRY(const auto standing, entry_at(path));
  if (!standing) return write_entry(path, find, trees).map([] { return Put::kNew; });

  const Case& old = standing->value;
  const bool is_of_failure = shows(old, failure);
  const Rank old_rank = rank_of(old.query);
  if (is_of_failure && old_rank < rank) return Put::kKnown;
  if (old_rank == rank) {
    United united = unite(*standing, find, trees, again);
    if (shows(united.value, failure)) return rewrite_entry(*standing, std::move(united));
    if (is_of_failure) return Put::kKnown;
  }
  if (is_of_failure && !has_tree(old) && !has_tree(find)) {
    return write_entry(path, find, trees).map([] { return Put::kSmaller; });
  }
  // The name of a tree follows from that of its entry: both cannot be replaced at one moment.
  CCDFUZZ_TRY(const auto aside, move_aside(*standing));
  return write_entry(path, find, trees).and_then([&]() -> Result<Put> {
    if (!is_of_failure) return Put::kNew;
    const Result<void> removed = aside ? remove_entry(*aside) : Result<void>();
    return removed.map([] { return Put::kSmaller; });
  });
}

Result<Store> Store::open(const std::string& folder) {
  auto state = std::make_unique<State>();
  // One spelling of each path, so that paths can be compared.
  state->folder = fs::path(folder).lexically_normal().string();
  if (state->folder.size() > 1 && state->folder.ends_with('/')) state->folder.pop_back();
  if (state->folder.empty()) return input_error("", "the name of the folder of finds is empty");
  CCDFUZZ_TRY_VOID(make_folder(state->folder));
  std::error_code error;
  state->home = state->folder + "/cases";
  if (!fs::is_directory(state->home, error)) {
    const std::string old = state->folder + "/regressions";
    if (fs::is_directory(old, error)) return input_error(old, "is called cases now: rename it");
    state->home = state->folder;
  }

  CCDFUZZ_TRY(const auto lock, FolderLock::take(state->home));
  state->home_folder = lock.folder();
  remove_leftovers(state->home);
  // Whoever cannot write should learn it now, and not when the first find is to be kept.
  if (auto probe = OutputFile::create(state->home + "/.probe"); !probe) {
    return input_error(state->home, probe.error().what);
  }
  CCDFUZZ_TRY_VOID(state->read_named());
  return Store(std::move(state));
}

Store::Store(std::unique_ptr<State> state) : state_(std::move(state)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Result<Store::Put> Store::put(const Failure& failure, const Case& find, const std::string& trees,
                              const AskAgain& again) {
  CCDFUZZ_VERIFY(shows(find, failure));
  CCDFUZZ_TRY_VOID(check_truth(find));
  return state_->locked([&] { return state_->put(failure, find, trees, again); });
}

Result<Store::Put> Store::put_named(const std::string& name, const Case& entry,
                                    const std::string& trees, const AskAgain& again) {
  CCDFUZZ_TRY_VOID(check_truth(entry));
  CCDFUZZ_TRY_VOID(check_name(name));
  return state_->locked([&]() -> Result<Put> {
    const std::string address = content_address(entry.query);
    constexpr size_t kLongest = 240;  // with ".trees.zst" as long as a file's name may be
    std::string path =
        fmt::format("{}/{}.json", state_->home, name.size() <= kLongest ? name : address);
    auto standing = entry_at(path);
    if (standing && *standing && content_address((*standing)->value.query) != address) {
      path = fmt::format("{}/{}.json", state_->home, address);
      standing = entry_at(path);
    }
    if (!standing) return tl::unexpected(standing.error());
    if (*standing) return rewrite_entry(**standing, unite(**standing, entry, trees, again));
    return write_entry(path, entry, trees).map([&] {
      state_->note_named({path, entry});
      return Put::kNew;
    });
  });
}

Result<std::optional<NamedCase>> Store::standing(const Failure& failure) {
  return state_->locked([&]() -> Result<std::optional<NamedCase>> {
    CCDFUZZ_TRY(std::optional<NamedCase> own, entry_at(state_->path_of(failure)));
    if (own && !shows(own->value, failure)) own.reset();
    const auto named = state_->named.find(failure);
    if (named == state_->named.end()) return own;
    if (own && rank_of(own->value.query) < named->second.rank) return own;
    return entry_at(named->second.path);
  });
}

Result<void> Store::disown(const Failure& failure, const std::string& path) {
  return state_->locked([&]() -> Result<void> {
    const auto named = state_->named.find(failure);
    if (named != state_->named.end() && named->second.path == path) state_->named.erase(named);
    if (path != state_->path_of(failure)) return {};
    const auto standing = entry_at(path);
    if (!standing || !*standing) return standing.map([](const auto&) {});
    return state_->move_aside(**standing).map([](const auto&) {});
  });
}

Result<std::vector<NamedCase>> Store::load() const {
  return state_->locked([&]() -> Result<std::vector<NamedCase>> {
    std::vector<NamedCase> entries;
    return for_each_entry(state_->folder, [&](const NamedCase& entry) { entries.push_back(entry); })
        .map([&] { return std::move(entries); });
  });
}

std::string Store::path_of(const Failure& failure) const {
  return state_->path_of(failure);
}

const std::string& Store::folder() const {
  return state_->folder;
}

std::uint64_t Store::times_replaced() const {
  const std::lock_guard one_at_a_time(state_->mutex);
  return state_->times_replaced;
}

}  // namespace ccdfuzz
