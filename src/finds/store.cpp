#include "finds/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <mutex>

#include "base/folder_lock.hpp"
#include "base/output_file.hpp"
#include "case/case_json.hpp"
#include "case/tree_file.hpp"
#include "certify/checker/check_truth.hpp"
#include "finds/store_index.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

namespace {

/// Letters, digits and ._- so that the name is a file name everywhere and never hidden.
Result<void> check_name(const std::string& name) {
  constexpr size_t kLongest = 100;
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return c < 128 && (std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-');
  });
  if (plain && !name.starts_with('.') && name.size() <= kLongest) return {};
  return input_error("origin.name",
                     fmt::format("\"{}\" is not a file name of at most {} letters, digits, '.', "
                                 "'_' and '-'",
                                 name, kLongest));
}

/// Removes an entry and then its tree, so that no entry names one that is not there.
Result<void> remove_entry(const std::string& path) {
  std::error_code error;
  fs::remove(path, error);
  if (!error) fs::remove(trees_path(path), error);
  if (error) return system_error(path, "remove", error.value());
  return {};
}

Result<void> write_entry(const std::string& path, const Case& value) {
  return write_file(path, to_json(value, JsonLayout::kReadable) + "\n");
}

}  // namespace

struct Store::State {
  std::string folder;
  std::string home;  ///< where entries are written; locked while that is done
  std::mutex mutex;
  StoreIndex index;
  OpenFolder home_folder;
  std::uint64_t times_replaced = 0;

  struct Plan {
    Added added = Added::kKnown;
    Case entry;            ///< what to write
    std::string path;      ///< where to
    std::string old_path;  ///< where its query stands already; may be empty
  };

  Result<FolderLock> enter();
  Result<Added> add(const Case& find, const std::string& trees);
  bool surely_known(const Case& find, const Rank& rank) const;
  Result<Plan> plan(const Case& find, const Rank& rank) const;
  Result<void> supersede(const Case& larger, const std::string& method, const Case& simpler);
  Result<void> take_away(const std::string& path, const std::set<FailureKey>& keys);
  Result<void> tidy();
};

/// Locks the folder, which is made again if it was removed, and brings the index up to date.
Result<FolderLock> Store::State::enter() {
  std::error_code error;
  fs::create_directories(home, error);
  if (error) return system_error(home, "make the folder", error.value());
  auto lock = FolderLock::take(home);
  if (!lock) return lock;
  if (OpenFolder now = lock->folder(); !(now == home_folder)) {
    home_folder = std::move(now);
    ++times_replaced;
  }
  if (auto read = index.refresh(folder, home); !read) return tl::unexpected(read.error());
  return lock;
}

/// True if what is known already tells that nothing would be written: entries of other processes
/// only ever make more finds superfluous.
bool Store::State::surely_known(const Case& find, const Rank& rank) const {
  if (const std::string* path = index.find(rank.second)) {
    const Case& known = index.entries().at(*path).value;
    return (find.origin.name.empty() || find.origin.name == known.origin.name) &&
           std::all_of(find.expect.begin(), find.expect.end(),
                       [&](const auto& e) { return known.expect.contains(e.first); });
  }
  const auto failures = failures_of(find);
  return !failures.empty() && find.origin.name.empty() &&
         std::all_of(failures.begin(), failures.end(), [&](const FailureKey& key) {
           const Rank* smallest = index.smallest(key, rank.second);
           return smallest != nullptr && *smallest < rank;
         });
}

/// What becomes of a find. Requires a fresh index.
Result<Store::State::Plan> Store::State::plan(const Case& find, const Rank& rank) const {
  Plan plan;
  const std::string* at = index.find(rank.second);
  if (at != nullptr) plan.old_path = *at;
  const Case before = at != nullptr ? index.entries().at(*at).value : Case();
  plan.entry = at != nullptr ? before : find;
  if (at == nullptr) plan.entry.expect.clear();
  const bool gets_a_name = before.origin.name.empty() && !find.origin.name.empty();
  if (gets_a_name) plan.entry.origin = find.origin;

  // A failure of which a smaller entry tells stays out, unless this one is kept by its name.
  const Origin& origin = plan.entry.origin;
  bool superfluous = false, smaller = false;
  for (const auto& [method, expected] : find.expect) {
    if (plan.entry.expect.contains(method)) continue;
    const FailureKey key = failure_key(plan.entry, method, expected);
    const Rank* rival = is_failure(expected.outcome) ? index.smallest(key, rank.second) : nullptr;
    if (rival != nullptr && *rival < rank && origin.name.empty()) {
      superfluous = true;
      continue;
    }
    smaller = smaller || rival != nullptr;
    plan.entry.expect[method] = expected;
  }

  if (at != nullptr) {
    plan.added = plan.entry == before ? Added::kKnown : Added::kMerged;
  } else if (superfluous && failures_of(plan.entry).empty()) {
    plan.added = Added::kKnown;
  } else {
    plan.added = smaller ? Added::kSmaller : Added::kNew;
  }
  plan.path =
      at != nullptr && !gets_a_name
          ? plan.old_path
          : fmt::format("{}/{}.json", home, origin.name.empty() ? rank.second : origin.name);
  if (plan.path != plan.old_path && fs::exists(plan.path)) {
    return input_error(plan.path, "holds another case of this name");
  }
  return plan;
}

Result<Store::Added> Store::State::add(const Case& find, const std::string& trees) {
  if (auto checked = check_truth(find); !checked) return tl::unexpected(checked.error());
  if (auto named = check_name(find.origin.name); !named) return tl::unexpected(named.error());
  const Rank rank = {size_of(find.query), content_address(find.query)};
  const std::lock_guard one_at_a_time(mutex);
  if (surely_known(find, rank)) return Added::kKnown;
  const auto lock = enter();
  if (!lock) return tl::unexpected(lock.error());

  auto todo = plan(find, rank);
  if (!todo) return tl::unexpected(todo.error());
  if (todo->added == Added::kKnown) return Added::kKnown;
  const bool known = !todo->old_path.empty(), at_new_path = todo->old_path != todo->path;
  Result<void> carried;
  if (at_new_path) {
    carried = carry_tree(todo->entry.truth, known ? trees_path(todo->old_path) : trees, todo->path);
  }
  const auto done =
      carried.and_then([&] { return write_entry(todo->path, todo->entry); })
          .and_then(
              [&] { return known && at_new_path ? remove_entry(todo->old_path) : Result<void>(); })
          .and_then([&] { return index.refresh(folder, home); })
          .and_then([&] { return tidy(); });
  if (!done) return tl::unexpected(done.error());
  return todo->added;
}

/// Makes the entry at `path` stand for these failures no more, and removes it if it then stands for
/// none.
Result<void> Store::State::take_away(const std::string& path, const std::set<FailureKey>& keys) {
  Case value = index.entries().at(path).value;
  std::erase_if(value.expect, [&](const auto& e) {
    return is_failure(e.second.outcome) && keys.contains(failure_key(value, e.first, e.second));
  });
  return failures_of(value).empty() ? remove_entry(path) : write_entry(path, value);
}

Result<void> Store::State::supersede(const Case& larger, const std::string& method,
                                     const Case& simpler) {
  const std::lock_guard one_at_a_time(mutex);
  const auto lock = enter();
  if (!lock) return tl::unexpected(lock.error());
  const std::string* old_path = index.find(content_address(larger.query));
  const std::string* path = index.find(content_address(simpler.query));
  if (old_path == nullptr || path == nullptr || *old_path == *path) return {};
  const Case& old = index.entries().at(*old_path).value;
  const Case& kept = index.entries().at(*path).value;
  const auto old_outcome = old.expect.find(method), outcome = kept.expect.find(method);
  if (index.entries().at(*old_path).fixed || old_outcome == old.expect.end() ||
      outcome == kept.expect.end() || old_outcome->second != outcome->second ||
      old.origin.contact != kept.origin.contact) {
    return {};
  }
  return take_away(*old_path, {failure_key(old, method, old_outcome->second)}).and_then([&] {
    return index.refresh(folder, home);
  });
}

/// Establishes law 3. Requires the lock and a fresh index; leaves the index fresh.
Result<void> Store::State::tidy() {
  std::map<std::string, std::set<FailureKey>> superfluous;
  for (const FailureKey& key : index.held_twice()) {
    const std::vector<std::string> holders = index.holders(key);
    for (size_t i = 1; i < holders.size(); ++i) {
      if (!index.entries().at(holders[i]).fixed) superfluous[holders[i]].insert(key);
    }
  }
  if (superfluous.empty()) return {};
  for (const auto& [path, keys] : superfluous) {
    if (auto taken = take_away(path, keys); !taken) return taken;
  }
  return index.refresh(folder, home);
}

Result<Store> Store::open(const std::string& folder) {
  auto state = std::make_unique<State>();
  // One spelling of each path, so that paths can be compared.
  state->folder = fs::path(folder).lexically_normal().string();
  if (state->folder.size() > 1 && state->folder.ends_with('/')) state->folder.pop_back();
  if (state->folder.empty()) return input_error("", "the name of the corpus folder is empty");
  std::error_code error;
  fs::create_directories(state->folder, error);
  if (error) return system_error(folder, "make the folder", error.value());
  state->home = state->folder + "/regressions";
  if (!fs::is_directory(state->home, error)) state->home = state->folder;

  const auto lock = FolderLock::take(state->home);
  if (!lock) return tl::unexpected(lock.error());
  state->home_folder = lock->folder();
  remove_leftovers(state->home);
  // Whoever cannot write should learn it now, and not when the first find is to be kept.
  if (auto probe = OutputFile::create(state->home + "/.probe"); !probe) {
    return input_error(state->home, probe.error().what);
  }
  if (auto read = state->index.refresh(state->folder, state->home); !read) {
    return tl::unexpected(read.error());
  }
  if (auto tidied = state->tidy(); !tidied) return tl::unexpected(tidied.error());
  return Store(std::move(state));
}

Store::Store(std::unique_ptr<State> state) : state_(std::move(state)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Result<Store::Added> Store::add(const Case& find, const std::string& trees) {
  return state_->add(find, trees);
}

Result<void> Store::supersede(const Case& larger, const std::string& method, const Case& simpler) {
  return state_->supersede(larger, method, simpler);
}

Result<std::vector<NamedCase>> Store::load() const {
  const std::lock_guard one_at_a_time(state_->mutex);
  const auto lock = state_->enter();
  if (!lock) return tl::unexpected(lock.error());
  std::vector<NamedCase> entries;
  for (const auto& [path, entry] : state_->index.entries()) entries.push_back({path, entry.value});
  return entries;
}

const std::string& Store::folder() const {
  return state_->folder;
}

std::uint64_t Store::times_replaced() const {
  const std::lock_guard one_at_a_time(state_->mutex);
  return state_->times_replaced;
}

}  // namespace ccdfuzz
