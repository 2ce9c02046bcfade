#pragma once

#include <sys/types.h>

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "case/case.hpp"
#include "finds/content_address.hpp"
#include "finds/failure.hpp"

namespace ccdfuzz {

/// The order of "smaller"; total, since different queries have different addresses.
using Rank = std::pair<CaseSize, std::string>;

/// What is in the files of a store, held in memory and brought up to date from the disk by reading
/// only the files that changed.
class StoreIndex {
 public:
  struct Entry {
    Case value;
    Rank rank;
    /// Never taken away: its file is called by a name and not by its address, or stands outside
    /// the folder that the store writes to.
    bool fixed = false;

   private:
    friend class StoreIndex;
    std::tuple<ino_t, off_t, time_t, long> stamp_;
  };

  /// Reads what changed in the folder since the last time; `home` is the one among its sub-folders,
  /// or itself, that the store writes to. Errors: as read_checked_cases; the index is empty then.
  Result<void> refresh(const std::string& folder, const std::string& home);

  const std::map<std::string, Entry>& entries() const { return entries_; }
  /// The path of the entry with this address, a fixed one first; null if there is none.
  const std::string* find(const std::string& address) const;
  /// The smallest entry that stands for a failure, leaving out the one with address `except`.
  const Rank* smallest(const FailureKey& key, const std::string& except) const;
  /// Paths of the entries that stand for a failure, the smallest first.
  std::vector<std::string> holders(const FailureKey& key) const;
  /// All failures that more than one entry stands for.
  std::vector<FailureKey> held_twice() const;

 private:
  std::map<std::string, Entry> entries_;                       // by path
  std::map<std::string, std::string> by_address_;              // to path
  std::map<FailureKey, std::map<Rank, std::string>> holders_;  // to path
};

}  // namespace ccdfuzz
