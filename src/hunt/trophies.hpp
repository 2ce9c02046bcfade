#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "corpus/store.hpp"
#include "hunt/hunt.hpp"

namespace ccdfuzz {

/// The counterexamples of one hunt on their way into the store. Safe from several threads.
class Trophies {
 public:
  Trophies(Store& store, const HuntOptions& options) : store_(store), options_(options) {}

  /// A method failed on a case. Stores it if it is the smallest of its signature so far.
  /// Errors: of the store.
  Result<void> offer(const std::string& method, const Case& asked, const Judged& judged);

  /// How many entries this hunt has added and, as far as it knows, still stand.
  size_t count() const;

  /// Minimises the entries that this hunt added, as options.shrink says, those first that show a
  /// failure like no other. Ends when stop() says so. Errors: of the store.
  Result<void> shrink(const std::function<bool()>& stop);

  /// Asks all methods about every entry that this hunt added, so that each says what to expect of
  /// every method that decides it; with few pops, since one slow method must not take minutes.
  /// Errors: of the store.
  Result<void> complete(const std::atomic<bool>& stop);

  /// What stands in the store by this hunt's doing. Errors: of the store.
  Result<std::vector<HuntFind>> finds() const;

 private:
  /// How many of the added entries are the smallest of a signature.
  size_t standing() const;
  bool shrinks(const std::string& method) const;

  using Rank = std::pair<CaseSize, std::string>;

  Store& store_;
  const HuntOptions& options_;
  mutable std::mutex mutex_;
  std::map<FailureKey, Rank> smallest_;
  std::set<std::string> added_;  ///< addresses
  size_t standing_ = 0;
};

}  // namespace ccdfuzz
