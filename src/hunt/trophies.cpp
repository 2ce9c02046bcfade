#include "hunt/trophies.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <tuple>

#include "base/enum_names.hpp"
#include "base/in_order.hpp"
#include "case/tree_file.hpp"
#include "hunt/expect_of_others.hpp"
#include "hunt/shrink.hpp"
#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

namespace {

/// Of one counterexample; most need fewer to come to an end.
constexpr std::uint64_t kShrinkTrials = 1000;

std::string address_of(const NamedCase& entry) {
  return content_address(entry.value.query);
}

}  // namespace

bool breaks_claim(const std::string& method, Outcome outcome) {
  if (!is_false_negative(outcome)) return false;
  const Result<MethodInfo> info = method_info(method);
  return info && info->claims_no_false_negative;
}

void Trophies::offer(const std::string& method, const Case& asked, const Judged& judged) {
  Case find = asked;
  find.asked = asked_with(options_.search);
  find.expect = {{method, Expected(judged.outcome, judged.error)}};
  const FailureKey key = failure_key(find, method, find.expect.at(method));
  const std::pair rank(size_of(asked.query), content_address(asked.query));
  const std::lock_guard lock(mutex_);
  const auto [known, is_first] = smallest_.try_emplace(key);
  if (!is_first && !(rank < known->second.rank)) return;
  known->second = {rank, std::move(find), false};
  std::ignore = store_kept();
}

Result<void> Trophies::store_all() {
  const std::lock_guard lock(mutex_);
  // Notices a folder that was replaced.
  if (const auto loaded = store_.load(); !loaded) return noted(tl::unexpected(loaded.error()));
  return store_kept();
}

Result<void> Trophies::store_kept() {
  Result<void> stored;
  constexpr int kPasses = 2;  // in the first the folder may turn out to have been replaced
  for (int pass = 0; stored && pass < kPasses; ++pass) {
    notice_replacement();
    for (auto& [key, smallest] : smallest_) {
      if (smallest.stored) continue;
      const Result<Store::Added> added = store_.add(smallest.find);
      if (!added) {
        stored = tl::unexpected(added.error());
        break;
      }
      smallest.stored = true;
      if (*added != Store::Added::kKnown) added_.insert(smallest.rank.second);
    }
  }
  notice_replacement();
  standing_ = standing();
  return noted(stored);
}

/// What was stored in a folder that is gone is kept only here.
void Trophies::notice_replacement() {
  const std::uint64_t times = store_.times_replaced();
  if (std::exchange(times_replaced_, times) == times) return;
  for (auto& [key, smallest] : smallest_) smallest.stored = false;
  std::ignore = noted(input_error(store_.folder(), "was removed"));
}

Result<void> Trophies::noted(Result<void> result) {
  if (!result && !trouble_) trouble_ = result.error();
  return result;
}

std::optional<InputError> Trophies::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

size_t Trophies::standing() const {
  std::set<std::string> addresses;
  for (const auto& [key, smallest] : smallest_) {
    const std::string& address = smallest.rank.second;
    if (!smallest.stored || added_.contains(address)) addresses.insert(address);
  }
  return addresses.size();
}

size_t Trophies::count() const {
  const std::lock_guard lock(mutex_);
  return standing_;
}

Result<void> Trophies::shrink(const std::function<bool()>& stop) {
  Result<std::vector<NamedCase>> entries = store_.load();
  if (!entries) return tl::unexpected(entries.error());
  struct Task {
    const Case* found;
    std::string method;
    Judged failure;
    std::pair<size_t, size_t> rank;  ///< how many like it come before, and how many in all
  };
  std::vector<Task> tasks;
  std::map<std::tuple<std::string, Outcome, std::string>, size_t> alike;
  for (const NamedCase& entry : *entries) {
    if (!added_.contains(address_of(entry))) continue;
    for (const auto& [method, expected] : entry.value.expect) {
      // An entry that was in the store before may expect something of a method that does not run.
      const bool runs = std::ranges::find(options_.methods, method) != options_.methods.end();
      if (!runs || !is_failure(expected.outcome) || !shrinks(method)) continue;
      Judged failure;
      failure.outcome = expected.outcome;
      if (failure.outcome == Outcome::kError) failure.error = expected.cause;
      const std::pair rank(alike[{method, failure.outcome, failure.error}]++, tasks.size());
      tasks.push_back({&entry.value, method, std::move(failure), rank});
    }
  }
  std::ranges::sort(tasks, {}, &Task::rank);
  tbb::enumerable_thread_specific<MethodSet> methods;
  Result<void> stored;
  size_t done = 0;
  std::atomic<bool> ended = false;
  run_in_order<Case>(
      tasks.size(), options_.threads,
      [&](size_t i) {
        const Task& task = tasks[i];
        return ccdfuzz::shrink(*task.found, task.method, methods.local()[task.method], task.failure,
                               options_.search, {kShrinkTrials, stop})
            .value;
      },
      [&](const Case& smaller) {
        const Task& task = tasks[done++];
        offer(task.method, smaller, task.failure);
        if (stored) stored = store_.supersede(*task.found, task.method, smaller);
        if (!stored || stop()) ended = true;
      },
      &ended);
  return stored;
}

bool Trophies::shrinks(const std::string& method) const {
  return options_.shrink == Shrink::kAll ||
         (options_.shrink == Shrink::kPlugins && names_plugin(method));
}

Result<void> Trophies::complete(const std::atomic<bool>& stop) {
  Result<std::vector<NamedCase>> entries = store_.load();
  if (!entries) return tl::unexpected(entries.error());
  std::erase_if(*entries, [this](const NamedCase& e) { return !added_.contains(address_of(e)); });
  tbb::enumerable_thread_specific<MethodSet> methods;
  Result<void> stored;
  run_in_order<Case>(
      entries->size(), options_.threads,
      [&](size_t i) {
        Case entry = (*entries)[i].value;
        expect_of_others(entry, options_.methods, methods.local(), options_.search,
                         trees_path((*entries)[i].id));
        return entry;
      },
      [&](const Case& entry) {
        if (!stored) return;
        if (auto added = store_.add(entry); !added) stored = tl::unexpected(added.error());
      },
      &stop);
  return stored;
}

std::vector<HuntFind> Trophies::finds() const {
  const std::lock_guard lock(mutex_);
  std::vector<HuntFind> finds;
  const auto add = [&](std::string path, Case value) {
    HuntFind find{std::move(path), std::move(value), {}, false};
    for (const auto& [method, expected] : find.value.expect) {
      if (!is_failure(expected.outcome)) continue;
      find.failures.push_back(method);
      find.breaks_claim = find.breaks_claim || breaks_claim(method, expected.outcome);
    }
    finds.push_back(std::move(find));
  };
  Result<std::vector<NamedCase>> entries = store_.load();
  if (entries) {
    for (NamedCase& entry : *entries) {
      if (added_.contains(address_of(entry))) add(entry.id, std::move(entry.value));
    }
  }
  for (const auto& [key, smallest] : smallest_) {
    const bool is_there = entries && smallest.stored;
    if (!is_there && (!smallest.stored || added_.contains(smallest.rank.second))) {
      add("", smallest.find);
    }
  }
  std::ranges::sort(finds, {}, [](const HuntFind& f) {
    return std::pair(enum_named<ContactClass>(f.value.origin.contact).value_or(ContactClass::kVV),
                     f.path);
  });
  return finds;
}

}  // namespace ccdfuzz
