#include "hunt/trophies.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>

#include "eval/in_order.hpp"
#include "hunt/expect_of_others.hpp"
#include "hunt/shrink.hpp"
#include "method/plugin/plugin_spec.hpp"
#include "query/tree_file.hpp"

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

Result<void> Trophies::offer(const std::string& method, const Case& asked, const Judged& judged) {
  Case find = asked;
  find.expect = {{method, judged.outcome}};
  set_error_name(find, method, judged.error);
  const FailureKey key = failure_key(find, method, judged.outcome);
  const Rank rank = {size_of(asked.query), content_address(asked.query)};
  const std::lock_guard lock(mutex_);
  const auto [known, is_first] = smallest_.emplace(key, rank);
  if (!is_first && !(rank < known->second)) return {};
  known->second = rank;
  const Result<Store::Added> added = store_.add(find);
  if (!added) return tl::unexpected(added.error());
  if (*added != Store::Added::kKnown) added_.insert(rank.second);
  standing_ = standing();
  return {};
}

size_t Trophies::standing() const {
  std::set<std::string> addresses;
  for (const auto& [key, rank] : smallest_) {
    if (added_.contains(rank.second)) addresses.insert(rank.second);
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
    for (const auto& [method, outcome] : entry.value.expect) {
      // An entry that was in the store before may expect something of a method that does not run.
      const bool runs = std::ranges::find(options_.methods, method) != options_.methods.end();
      if (!runs || !is_failure(outcome) || !shrinks(method)) continue;
      Judged failure;
      failure.outcome = outcome;
      failure.error = error_name(entry.value, method);
      const std::pair rank(alike[{method, outcome, failure.error}]++, tasks.size());
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
        stored = stored.and_then([&] { return offer(task.method, smaller, task.failure); })
                     .and_then([&] { return store_.supersede(*task.found, task.method, smaller); });
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

Result<std::vector<HuntFind>> Trophies::finds() const {
  Result<std::vector<NamedCase>> entries = store_.load();
  if (!entries) return tl::unexpected(entries.error());
  std::vector<HuntFind> finds;
  for (NamedCase& entry : *entries) {
    if (!added_.contains(address_of(entry))) continue;
    HuntFind find{entry.id, std::move(entry.value), {}, false};
    for (const auto& [method, outcome] : find.value.expect) {
      if (!is_failure(outcome)) continue;
      find.failures.push_back(method);
      find.breaks_claim = find.breaks_claim || breaks_claim(method, outcome);
    }
    finds.push_back(std::move(find));
  }
  std::ranges::sort(finds, {}, [](const HuntFind& f) {
    return std::pair(contact_class_named(f.value.origin.contact).value_or(ContactClass::kVV),
                     f.path);
  });
  return finds;
}

}  // namespace ccdfuzz
