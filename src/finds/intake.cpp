#include "finds/intake.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>

#include "certify/checker/check_case.hpp"
#include "files/check_file.hpp"
#include "files/tree_file.hpp"
#include "io/in_order.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

namespace {

/// A file may name anything; no plug-in is made that nobody admitted.
bool can_be_asked(const std::string& method) {
  return make_method(method).has_value();
}

}  // namespace

bool Intake::offer(const Failure& failure, Case find) {
  find.expect.try_emplace(failure.who, failure.outcome, failure.cause);
  Rank rank = rank_of(find.query);
  const std::lock_guard lock(mutex_);
  const auto [known, is_first] = kept_.try_emplace(failure);
  Kept& kept = known->second;
  if (!is_first && !(rank < kept.rank)) return false;
  kept = {std::move(rank), std::move(find), false, kept.is_new};
  std::ignore = store_kept();
  return is_first && (kept.is_new || !kept.stored);
}

AskAgain Intake::again() {
  return [this](const std::string& method, const CheckedCase& known) -> std::optional<Expected> {
    if (!can_be_asked(method)) {
      ++settled_.kept[method];
      return std::nullopt;
    }
    ++settled_.asked;
    return confirm_.expected_as_asked(method, known);
  };
}

Result<Store::Put> Intake::take(const NamedCase& entry) {
  const std::lock_guard lock(mutex_);
  const std::string trees = trees_path(entry.file);
  const std::optional<Failure> failure = named_by_failure(entry);
  if (!failure) return store_.put_named(fs::path(entry.id).stem(), entry.value, trees, again());
  if (!can_be_asked(failure->who)) return put_aside(entry, *failure);
  if (fails_so(entry, *failure)) return put(*failure, entry.value, trees, again());
  doubtful_.push_back(entry.id);
  return Store::Put::kKnown;
}

/// Puts an entry whose failure could not be confirmed, or was refuted by its method. It is named
/// by the address of its query if another entry is stored for the failure, or none is and its
/// method refuted it.
Result<Store::Put> Intake::put_aside(const NamedCase& entry, const Failure& failure) {
  const std::string trees = trees_path(entry.file);
  CCDFUZZ_TRY(const std::optional<NamedCase> standing, store_.standing(failure));
  const std::string address = content_address(entry.value.query);
  const bool is_there = standing && content_address(standing->value.query) == address;
  const bool may_stand = is_there || (!standing && !can_be_asked(failure.who));
  return may_stand ? store_.put(failure, entry.value, trees, again())
                   : store_.put_named(address, entry.value, trees, again());
}

Result<std::uint64_t> Intake::take_doubtful() {
  const std::lock_guard lock(mutex_);
  std::uint64_t changed = 0;
  for (const std::string& path : std::exchange(doubtful_, {})) {
    CCDFUZZ_TRY(const NamedCase entry, read_checked_case(path));
    const std::optional<Failure> failure = named_by_failure(entry);
    if (!failure) continue;  // changed since
    CCDFUZZ_TRY(const Store::Put done, put_aside(entry, *failure));
    if (done != Store::Put::kKnown) ++changed;
  }
  return changed;
}

Result<bool> Intake::has(const Failure& failure) {
  const std::lock_guard lock(mutex_);
  if (kept_.contains(failure) || confirmed_.contains(failure)) return true;
  for (;;) {
    CCDFUZZ_TRY(const auto shown, confirm_standing(failure));
    if (!shown || *shown) return shown.has_value();
  }
}

/// Whether the method of the failure fails so on an entry, when it is asked as the entry says.
bool Intake::fails_so(const NamedCase& entry, const Failure& failure) {
  const auto known = check_case(entry);
  return known && failure_of(known->value(), failure.who,
                             confirm_.expected_as_asked(failure.who, *known)) == failure;
}

/// Whether the smallest entry that says that it shows the failure does when its method is asked
/// again; one that does not is disowned. Nothing where there is no such entry.
Result<std::optional<bool>> Intake::confirm_standing(const Failure& failure) {
  CCDFUZZ_TRY(const std::optional<NamedCase> entry, store_.standing(failure));
  if (!entry) return std::nullopt;
  if (fails_so(*entry, failure)) {
    confirmed_.insert(failure);
    return true;
  }
  return store_.disown(failure, entry->id).map([] { return std::optional(false); });
}

Result<Store::Put> Intake::put(const Failure& failure, const Case& find, const std::string& trees,
                               const AskAgain& again) {
  for (;;) {
    CCDFUZZ_TRY(const Store::Put done, store_.put(failure, find, trees, again));
    if (done != Store::Put::kKnown) confirmed_.insert(failure);
    if (confirmed_.contains(failure)) return done;
    CCDFUZZ_TRY(const auto shown, confirm_standing(failure));
    if (!shown || *shown) return done;
  }
}

Result<void> Intake::store_all() {
  const std::lock_guard lock(mutex_);
  return store_kept();
}

Result<void> Intake::store_kept() {
  const auto is_stored = [](const auto& entry) { return entry.second.stored; };
  Result<void> stored = notice_replacement();
  while (stored && !std::ranges::all_of(kept_, is_stored)) {
    for (auto& [failure, kept] : kept_) {
      if (kept.stored) continue;
      const Result<Store::Put> done = put(failure, kept.find);
      if (!done) {
        // Where one cannot be stored, the others are no worse off.
        if (stored) stored = tl::unexpected(done.error());
        continue;
      }
      kept.stored = true;
      kept.is_new = kept.is_new || *done == Store::Put::kNew || *done == Store::Put::kSmaller;
    }
    if (stored) stored = notice_replacement();
  }
  return noted(stored);
}

/// A find that was stored in a folder that is gone is kept only here.
Result<void> Intake::notice_replacement() {
  CCDFUZZ_TRY(const std::uint64_t times, store_.times_replaced());
  if (std::exchange(times_replaced_, times) == times) return {};
  for (auto& [failure, kept] : kept_) kept.stored = false;
  confirmed_.clear();
  std::ignore = noted(input_error(store_.folder(), "was removed"));
  return {};
}

Result<void> Intake::noted(Result<void> result) {
  if (!result && !trouble_) trouble_ = result.error();
  return result;
}

std::optional<InputError> Intake::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

size_t Intake::count() const {
  const std::lock_guard lock(mutex_);
  return static_cast<size_t>(std::ranges::count_if(
      kept_, [](const auto& kept) { return kept.second.is_new || !kept.second.stored; }));
}

Result<void> Intake::finish(const Finish& how) {
  struct Task {
    Failure failure;
    Case find;
    double depth = 0;
    bool differs = false;
  };
  std::vector<Task> tasks;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [failure, kept] : kept_) {
      if (kept.is_new || !kept.stored) tasks.push_back({failure, kept.find});
    }
  }
  tbb::enumerable_thread_specific<Asker> askers(make_);
  size_t done = 0;
  run_in_order<Case>(
      tasks.size(), how.threads,
      [&](size_t i) {
        auto& [failure, find, depth, differs] = tasks[i];
        Asker& asker = askers.local();
        if (how.shrinks(failure))
          find = minimise(find, failure, asker, {how.max_trials, how.is_late, how.admits}).value;
        const CheckedCase known = checked_or_unknown(find);
        if (is_false_negative(failure.outcome)) depth = asker.depth(failure.who, known);
        const Expected shown{failure.outcome, failure.cause};
        differs = !how.is_late() && asker.differs(failure.who, known, shown, asker.search());
        asker.ask_others(find, how.methods);
        return std::move(find);
      },
      [&](Case find) {
        const auto& [failure, was, depth, differs] = tasks[done++];
        const std::lock_guard lock(mutex_);
        Kept& kept = kept_.at(failure);
        kept = {rank_of(find.query), std::move(find), false, kept.is_new, depth, differs};
        std::ignore = store_kept();
      },
      &how.stop);
  return store_all();
}

std::vector<Find> Intake::finds() const {
  const std::lock_guard lock(mutex_);
  std::vector<Find> finds;
  for (const auto& [failure, kept] : kept_) {
    Find find{failure,    kept.stored ? store_.path_of(failure) : "",
              kept.find,  kept.is_new || !kept.stored,
              kept.depth, kept.differs};
    if (!find.is_new) {
      if (const auto entry = store_.standing(failure); entry && *entry) {
        find.path = (*entry)->id;
        find.value = (*entry)->value;
      }
    }
    finds.push_back(std::move(find));
  }
  return finds;
}

}  // namespace ccdfuzz
