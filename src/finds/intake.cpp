#include "finds/intake.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>

#include "base/no_process.hpp"
#include "base/stopwatch.hpp"
#include "certify/checker/check_case.hpp"
#include "files/check_file.hpp"
#include "io/in_order.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

namespace {

/// A file may name anything; no plug-in is made that nobody admitted.
bool can_be_asked(const std::string& method) {
  return make_method(method).has_value();
}

}  // namespace

bool Intake::offer(const Failure& failure, Case find, const Judged& judged) {
  find.expect.try_emplace(failure.who, failure.outcome, failure.cause);
  say_version(find, failure.who, judged);
  Rank rank = rank_of(find.query);
  const std::lock_guard lock(mutex_);
  const auto known = kept_.find(failure);
  const bool is_first = known == kept_.end();
  if (!is_first && !(rank < known->second.rank)) return false;
  keep({.failure = failure, .value = std::move(find)}, std::move(rank));
  return is_first && kept_.at(failure).is_new();
}

/// In place of what is kept for its failure, and stores it.
void Intake::keep(Find find, Rank rank) {
  Kept& kept = kept_[find.failure];
  find.is_new = kept.find.is_new;
  kept = {std::move(rank), std::move(find)};
  std::ignore = store_kept();
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
  const std::optional<Failure> failure = named_by_failure(entry);
  if (!failure) return store_.put_named(fs::path(entry.id).stem(), entry.value, again());
  if (!can_be_asked(failure->who)) return put_aside(entry, *failure);
  if (fails_so(entry, *failure)) return put(*failure, entry.value, again());
  doubtful_.push_back(entry.id);
  return Store::Put::kKnown;
}

/// Puts an entry whose failure could not be confirmed, or was refuted by its method. It is named
/// by the address of its query if another entry is stored for the failure, or none is and its
/// method refuted it.
Result<Store::Put> Intake::put_aside(const NamedCase& entry, const Failure& failure) {
  CCDFUZZ_TRY(const std::optional<NamedCase> standing, store_.standing(failure));
  const bool may_stand = !standing && !can_be_asked(failure.who);
  return may_stand ? store_.put(failure, entry.value, again())
                   : store_.put_aside(failure, entry.value, again());
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

Result<Store::Put> Intake::put(const Failure& failure, const Case& find, const AskAgain& again) {
  for (;;) {
    CCDFUZZ_TRY(const Store::Put done, store_.put(failure, find, again));
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
      const Result<Store::Put> done = put(failure, kept.find.value);
      if (!done) {
        // Where one cannot be stored, the others are no worse off.
        if (stored) stored = tl::unexpected(done.error());
        continue;
      }
      kept.stored = true;
      if (*done == Store::Put::kNew || *done == Store::Put::kSmaller) kept.find.is_new = true;
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
  return static_cast<size_t>(
      std::ranges::count_if(kept_, [](const auto& kept) { return kept.second.is_new(); }));
}

/// Minimises a new find for at most so long, measures it, and asks all methods about it.
void Intake::complete(Find& find, Asker& asker, const Finish& how, double seconds) {
  const Failure& failure = find.failure;
  const Stopwatch watch;
  const auto is_over = [&] { return how.stop || watch.seconds() > seconds; };
  if (how.shrinks(failure)) {
    find.value =
        minimise(find.value, failure, asker, {.stop = is_over, .admits = how.admits}).value;
    find.cut_short = is_over();
  }
  const CheckedCase known = checked_or_unknown(find.value);
  find.judged = asker.ask_how_deep(failure, known);
  say_version(find.value, failure.who, find.judged);
  const Expected shown{failure.outcome, failure.cause};
  find.differs = !how.stop && asker.differs(failure.who, known, shown, asker.search());
  if (!find.differs) find.value.origin.more.erase(kNote);
  asker.ask_others(find.value, how.methods);
}

Result<void> Intake::finish(const Finish& how) {
  std::vector<Find> tasks;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [failure, kept] : kept_) {
      if (kept.is_new()) tasks.push_back(kept.find);
    }
  }
  tbb::enumerable_thread_specific<Asker> askers(make_);
  run_in_order<Find>(
      tasks.size(), how.threads,
      [&](size_t i) {
        Find find = std::move(tasks[i]);
        // Those that are minimised at once take the same time.
        const double share = std::min(1.0, how.threads / static_cast<double>(tasks.size() - i));
        try {
          complete(find, askers.local(), how, share * how.seconds_left());
        } catch (const NoProcess&) {
          if (!how.stop) throw;
        }
        return find;
      },
      [&](Find find) {
        Rank rank = rank_of(find.value.query);
        const std::lock_guard lock(mutex_);
        keep(std::move(find), std::move(rank));
      },
      &how.stop);
  return store_all();
}

std::vector<Find> Intake::finds() const {
  const std::lock_guard lock(mutex_);
  std::vector<Find> finds;
  for (const auto& [failure, kept] : kept_) {
    Find& find = finds.emplace_back(kept.find);
    find.is_new = kept.is_new();
    if (kept.stored) find.path = store_.path_of(failure);
    if (find.is_new) continue;
    if (const auto entry = store_.standing(failure); entry && *entry) {
      find.path = (*entry)->id;
      find.value = (*entry)->value;
    }
  }
  return finds;
}

}  // namespace ccdfuzz
