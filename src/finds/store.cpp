#include "finds/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "base/verify.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "files/case_json.hpp"
#include "files/check_file.hpp"
#include "io/input_bytes.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

namespace {

/// Not one that is hidden, or would lie in another folder.
Result<void> check_name(const std::string& name) {
  const bool is_plain = name.find_first_of(std::string_view("/\0", 2)) == std::string::npos;
  if (is_plain && !name.empty() && !name.starts_with('.')) return {};
  return input_error("",
                     "\"{}\" is not a file name: it is empty, begins with '.' or "
                     "has a '/' or a zero byte in it",
                     name);
}

bool shows(const Case& value, const Failure& failure) {
  const std::vector<Failure> shown = failures_of(value);
  return std::ranges::find(shown, failure) != shown.end();
}

Result<void> write_entry(const std::string& path, const Case& value) {
  return write_file(path, to_json(value, JsonLayout::kReadable) + "\n");
}

/// How much a truth says of absence of contact: whether by a certificate, until when, whether that
/// is included.
std::tuple<bool, Rational, bool> absence_of(const Truth& truth, const Rational& t_max) {
  const bool is_clear = truth.collides == false;
  Rational until = is_clear ? t_max : Rational(0);
  if (truth.clear_until && *truth.clear_until > until) until = *truth.clear_until;
  if (truth.clearance) until = until_of(*truth.clearance);
  const bool includes = truth.clearance ? covers(*truth.clearance, until) : is_clear;
  return {truth.clearance.has_value(), until, includes};
}

/// Takes the part of another truth over if there is none, or it is earlier by `time`.
template <class Part, class Time>
void take_earlier(std::optional<Part>& part, const std::optional<Part>& other, const Time& time) {
  if (other && (!part || time(*other) < time(*part))) part = other;
}

Truth united_truth(const Truth& old, const Truth& find, const Rational& t_max) {
  Truth truth = old;
  take_earlier(truth.witness, find.witness, [](const Witness& w) { return w.t; });
  take_earlier(truth.contact_box, find.contact_box, [](const ContactBox& b) { return b.until(); });
  take_earlier(truth.contact_root, find.contact_root, [](const ContactRoot& r) { return r.by; });
  const Truth& absence = absence_of(old, t_max) < absence_of(find, t_max) ? find : old;
  truth.clear_until = absence.clear_until;
  truth.clearance = absence.clearance;
  truth.proof = absence.proof;
  truth.collides = std::nullopt;
  const bool is_clear_to_end = !truth.clearance || covers(*truth.clearance, t_max);
  if ((old.collides == false || find.collides == false) && is_clear_to_end) truth.collides = false;
  if (old.collides == true || find.collides == true) truth.collides = true;
  if (truth.clearance) return truth;
  // A method's word falls with a contact that is proven.
  const std::optional<Rational> by = truth.contact_by();
  if (truth.clear_until && by && *by < *truth.clear_until) truth.clear_until.reset();
  if (truth.collides == true && !truth.clear_until) truth.proof.reset();
  if (truth.collides == false) truth.proof = kProofWords[2];
  return truth;
}

/// Two entries of one query as one. Takes each part of the truths from where it is stronger. That
/// is the earlier contact; and absence of contact by certificate before any by a method's word, or
/// the later of two. The rest is of `old`, but for a depth that only `find` has. Requires that both
/// truths were checked.
Case unite(const Case& old, const Case& find, const AskAgain& again) {
  Case value = old;
  value.truth = united_truth(old.truth, find.truth, exact(old.query.t_max));
  const bool is_of_both = value.truth != old.truth && value.truth != find.truth;
  if (is_of_both && !check_case(value)) value.truth = old.truth;

  const auto stands_by = [&](const Case& entry) {
    return entry.truth == value.truth && entry.asked == value.asked;
  };
  const bool is_old_sure = stands_by(old), is_find_sure = stands_by(find);
  value.expect.insert(find.expect.begin(), find.expect.end());
  take_depth(value, find);
  if (!again) return value;
  std::optional<CheckedCase> known;
  for (auto& [method, expected] : value.expect) {
    const auto by_old = old.expect.find(method);
    const auto by_find = find.expect.find(method);
    const bool is_of_old = by_old != old.expect.end();
    const bool is_of_find = by_find != find.expect.end();
    const bool is_disputed = is_of_old && is_of_find && !(by_old->second == by_find->second);
    const bool is_sure = (is_old_sure && is_of_old) || (is_find_sure && is_of_find);
    if (is_sure && !is_disputed) continue;
    if (!known) known = checked_or_unknown(value);
    if (const auto shown = again(method, *known)) expected = *shown;
  }
  return value;
}

/// Makes an entry say what a united one does.
Result<Store::Put> rewrite_entry(const NamedCase& old, const Case& united) {
  if (united == old.value) return Store::Put::kKnown;
  return write_entry(old.id, united).map([] { return Store::Put::kMerged; });
}

/// The entry of a file; nothing where there is no file. Errors: as read_checked_case.
Result<std::optional<NamedCase>> entry_at(const std::string& path) {
  std::error_code error;
  if (fs::symlink_status(path, error).type() == fs::file_type::not_found) return std::nullopt;
  return refuse_irregular(path)
      .and_then([&] { return read_checked_case(path); })
      .map([](NamedCase entry) { return std::optional(std::move(entry)); });
}

}  // namespace

std::optional<Failure> named_by_failure(const NamedCase& entry) {
  const std::string stem = fs::path(entry.id).stem();
  for (const Failure& failure : failures_of(entry.value)) {
    if (file_stem(failure) == stem) return failure;
  }
  return std::nullopt;
}

/// Locks the folder, which is made again if it was removed.
Result<FolderLock> Store::enter() {
  CCDFUZZ_TRY_VOID(make_folder(home_));
  CCDFUZZ_TRY(auto lock, FolderLock::take(home_));
  if (!lock.is_of(home_folder_)) {
    home_folder_ = lock.folder();
    ++times_replaced_;
    CCDFUZZ_TRY_VOID(read_named());
  }
  return lock;
}

/// The result of work(), one at a time, in the locked folder.
template <class Work>
auto Store::locked(const Work& work) -> decltype(work()) {
  const std::lock_guard one_at_a_time(*mutex_);
  CCDFUZZ_TRY(const auto lock, enter());
  return work();
}

Result<void> Store::read_named() {
  return for_each_entry(folder_, [&](const NamedCase& entry) {
    if (fs::path(entry.id).parent_path() != home_ || !named_by_failure(entry)) know(entry);
  });
}

void Store::know(const NamedCase& entry) {
  for (const Failure& failure : failures_of(entry.value)) {
    named_.insert({failure, rank_of(entry.value.query), entry.id});
  }
}

/// The smallest entry of any other name that shows the failure, as its file is now.
Result<std::optional<NamedCase>> Store::named(const Failure& failure) {
  auto at = named_.lower_bound({failure});
  while (at != named_.end() && at->failure == failure) {
    CCDFUZZ_TRY(auto entry, entry_at(at->path));
    if (entry && shows(entry->value, failure)) return entry;
    at = named_.erase(at);
  }
  return std::nullopt;
}

/// Gives an entry its address as its name. If its query is there already, that entry stays
/// and says of it what both do.
Result<void> Store::move_aside(const NamedCase& entry) const {
  const std::string aside = path_of(content_address(entry.value.query));
  CCDFUZZ_TRY(const auto standing, entry_at(aside));
  std::error_code error;
  if (standing) {
    CCDFUZZ_TRY_VOID(rewrite_entry(*standing, unite(standing->value, entry.value, nullptr)));
    fs::remove(entry.id, error);
  } else {
    fs::rename(entry.id, aside, error);
  }
  if (error) return system_error(entry.id, "rename", error.value());
  return {};
}

Result<Store::Put> Store::put_locked(const Failure& failure, const Case& find,
                                     const AskAgain& again) {
  const std::string path = path_of(failure);
  const Rank rank = rank_of(find.query);
  CCDFUZZ_TRY(const auto known, named(failure));
  if (known && rank_of(known->value.query) <= rank) {
    if (!again || rank_of(known->value.query) < rank) return Put::kKnown;
    return rewrite_entry(*known, unite(known->value, find, again));
  }
  CCDFUZZ_TRY(const auto standing, entry_at(path));
  if (!standing) return write_entry(path, find).map([] { return Put::kNew; });

  const Case& old = standing->value;
  const bool is_of_failure = shows(old, failure);
  const Rank old_rank = rank_of(old.query);
  if (is_of_failure && old_rank < rank) return Put::kKnown;
  if (old_rank == rank) {
    const Case united = unite(old, find, again);
    if (shows(united, failure)) return rewrite_entry(*standing, united);
    if (is_of_failure) return Put::kKnown;
  }
  if (!is_of_failure) CCDFUZZ_TRY_VOID(move_aside(*standing));
  return write_entry(path, find).map([&] { return is_of_failure ? Put::kSmaller : Put::kNew; });
}

Result<Store> Store::open(const std::string& folder) {
  Store store;
  // One spelling of each path, so that paths can be compared.
  store.folder_ = fs::path(folder).lexically_normal().string();
  if (store.folder_.size() > 1 && store.folder_.ends_with('/')) store.folder_.pop_back();
  if (store.folder_.empty()) return input_error("", "the name of the folder of finds is empty");
  CCDFUZZ_TRY_VOID(make_folder(store.folder_));
  std::error_code error;
  store.home_ = store.folder_ + "/cases";
  if (!fs::is_directory(store.home_, error)) {
    const std::string old = store.folder_ + "/regressions";
    if (fs::is_directory(old, error)) return input_error(old, "is called cases now: rename it");
    store.home_ = store.folder_;
  }

  CCDFUZZ_TRY(const auto lock, FolderLock::take(store.home_));
  store.home_folder_ = lock.folder();
  // Whoever cannot write should learn it now, and not when the first find is to be kept.
  CCDFUZZ_TRY_VOID(make_writable_folder(store.home_));
  CCDFUZZ_TRY_VOID(store.read_named());
  return store;
}

Result<Store::Put> Store::put(const Failure& failure, const Case& find, const AskAgain& again) {
  CCDFUZZ_VERIFY(shows(find, failure));
  CCDFUZZ_TRY_VOID(check_truth(find));
  return locked([&] { return put_locked(failure, find, again); });
}

Result<Store::Put> Store::put_named(const std::string& name, const Case& entry,
                                    const AskAgain& again) {
  CCDFUZZ_TRY_VOID(check_truth(entry));
  CCDFUZZ_TRY_VOID(check_name(name));
  constexpr size_t kLongest = 250;  // with ".json" as long as a file's name may be
  return locked([&]() -> Result<Put> {
    const std::string address = content_address(entry.query);
    std::string path = path_of(name.size() <= kLongest ? name : address);
    CCDFUZZ_TRY(const auto standing, entry_at(path));
    if (standing && content_address(standing->value.query) != address) path = path_of(address);
    return put_at(path, entry, again);
  });
}

Result<Store::Put> Store::put_aside(const Failure& failure, const Case& entry,
                                    const AskAgain& again) {
  CCDFUZZ_TRY_VOID(check_truth(entry));
  return locked([&]() -> Result<Put> {
    const Rank rank = rank_of(entry.query);
    std::vector<std::string> paths = {path_of(failure)};
    const auto named = named_.lower_bound({failure, rank});
    if (named != named_.end() && named->failure == failure) paths.push_back(named->path);
    for (const std::string& path : paths) {
      CCDFUZZ_TRY(const auto standing, entry_at(path));
      const bool is_of_query = standing && rank_of(standing->value.query) == rank;
      if (is_of_query) return rewrite_entry(*standing, unite(standing->value, entry, again));
    }
    return put_at(path_of(content_address(entry.query)), entry, again);
  });
}

/// Unites an entry with that of its query in this file, or begins the file.
Result<Store::Put> Store::put_at(const std::string& path, const Case& entry,
                                 const AskAgain& again) {
  CCDFUZZ_TRY(const auto standing, entry_at(path));
  if (standing) return rewrite_entry(*standing, unite(standing->value, entry, again));
  return write_entry(path, entry).map([&] {
    know({path, entry});
    return Put::kNew;
  });
}

Result<std::optional<NamedCase>> Store::standing(const Failure& failure) {
  return locked([&]() -> Result<std::optional<NamedCase>> {
    CCDFUZZ_TRY(std::optional<NamedCase> own, entry_at(path_of(failure)));
    if (own && !shows(own->value, failure)) own.reset();
    CCDFUZZ_TRY(std::optional<NamedCase> other, named(failure));
    if (!other || (own && rank_of(own->value.query) < rank_of(other->value.query))) return own;
    return other;
  });
}

Result<void> Store::disown(const Failure& failure, const std::string& path) {
  return locked([&]() -> Result<void> {
    std::erase_if(named_,
                  [&](const Named& one) { return one.failure == failure && one.path == path; });
    if (path != path_of(failure)) return {};
    const auto standing = entry_at(path);
    if (!standing || !*standing) return standing.map([](const auto&) {});
    return move_aside(**standing);
  });
}

Result<std::vector<NamedCase>> Store::load() {
  return locked([&]() -> Result<std::vector<NamedCase>> {
    std::vector<NamedCase> entries;
    return for_each_entry(folder_, [&](const NamedCase& entry) { entries.push_back(entry); })
        .map([&] { return std::move(entries); });
  });
}

std::string Store::path_of(const Failure& failure) const {
  return path_of(file_stem(failure));
}

std::string Store::path_of(const std::string& stem) const {
  return fmt::format("{}/{}.json", home_, stem);
}

Result<std::uint64_t> Store::times_replaced() {
  return locked([&]() -> Result<std::uint64_t> { return times_replaced_; });
}

}  // namespace ccdfuzz
