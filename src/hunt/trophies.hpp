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

#include "finds/store.hpp"
#include "hunt/hunt.hpp"

namespace ccdfuzz {

/// The counterexamples of one hunt on their way into the store. Holds the smallest of each
/// signature in memory, so that none is lost while the store cannot be written, or with its folder:
/// whenever something is to be stored, all that is not in the store is. Safe from several threads.
class Trophies {
 public:
  Trophies(Store& store, const HuntOptions& options) : store_(store), options_(options) {}

  /// A method failed on a case. Keeps it if it is the smallest of its signature so far.
  void offer(const std::string& method, const Case& asked, const Judged& judged);

  /// Stores all that is kept and not in the store. Errors: of the store; nothing is forgotten then.
  Result<void> store_all();

  /// The first thing that went wrong with the store, if anything did.
  std::optional<InputError> trouble() const;

  /// How many counterexamples this hunt has added or keeps and, as far as it knows, still stand.
  size_t count() const;

  /// Minimises the entries that this hunt added, as options.shrink says, those first that show a
  /// failure like no other. Ends when stop() says so. Errors: of the store.
  Result<void> shrink(const std::function<bool()>& stop);

  /// Asks all methods about every entry that this hunt added, so that each says what to expect of
  /// every method that decides it; with few pops, since one slow method must not take minutes.
  /// Errors: of the store.
  Result<void> complete(const std::atomic<bool>& stop);

  /// What stands in the store by this hunt's doing, and what it keeps because it cannot be stored.
  std::vector<HuntFind> finds() const;

 private:
  /// How many of the added entries are the smallest of a signature.
  size_t standing() const;
  Result<void> store_kept();
  void notice_replacement();
  /// Remembers the first error.
  Result<void> noted(Result<void> result);
  bool shrinks(const std::string& method) const;

  /// The smallest failure of a signature.
  struct Smallest {
    std::pair<CaseSize, std::string> rank;  ///< with its address
    Case find;
    bool stored = false;
  };

  Store& store_;
  const HuntOptions& options_;
  mutable std::mutex mutex_;
  std::map<FailureKey, Smallest> smallest_;
  std::set<std::string> added_;  ///< addresses
  std::uint64_t times_replaced_ = 0;
  std::optional<InputError> trouble_;
  size_t standing_ = 0;
};

}  // namespace ccdfuzz
