#pragma once

#include <compare>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "files/case_files.hpp"
#include "finds/content_address.hpp"
#include "finds/entries.hpp"
#include "finds/failure.hpp"
#include "io/folder_lock.hpp"

namespace ccdfuzz {

/// The outcome of a method now on a case; nothing where it cannot be asked. Asked about each method
/// on which two entries of one query disagree, or whose outcome was judged by a weaker truth or
/// asked in another way. Without it, or where it does not know, the outcome of the older entry
/// stays, and else that of the other.
using AskAgain =
    std::function<std::optional<Expected>(const std::string& method, const CheckedCase& known)>;

/// A folder of finds, one readable .json file for each failure, named by it (file_stem). Entries
/// of any other name, those of sub-folders among them, are kept for themselves. A store removes
/// none of them, and changes one only where another of its query is put. It need not hold another
/// find for what they show.
///
/// Laws, with any number of threads and processes writing to one folder, and after SIGKILL at any
/// moment:
///  1. Every entry is complete.
///  2. The entry of a failure is the smallest, by Rank, of all finds that were put for it. So what
///     is kept does not depend on the order.
///  3. If two entries have one query, the stronger truth stays. Another find changes no
///     expectation, unless the caller asks the method again.
class Store {
 public:
  enum class Put {
    kNew,      ///< the first of its failure
    kSmaller,  ///< took the place of a larger one
    kMerged,   ///< the query was there, and now says more of it
    kKnown,    ///< nothing new, nothing written
  };

  /// Opens a folder, making it if need be. If it has a sub-folder `cases`, finds are written there.
  /// Errors: the folder cannot be made, read, written or locked; an entry cannot be read; it has
  /// `regressions`, the old name, and no `cases`.
  static Result<Store> open(const std::string& folder);

  /// Puts a find that shows a failure, and makes the folder again if it was removed. Safe from
  /// several threads. Requires that the find expects the failure. Errors: a refuted truth; a full
  /// disk or any other refusal of the system, after which the entries so far remain.
  Result<Put> put(const Failure& failure, const Case& find, const AskAgain& again = nullptr);

  /// Puts an entry under a name of its own (without ".json"). It goes under its address if another
  /// case has the name or it is too long for a file. Errors: as put; no file name.
  Result<Put> put_named(const std::string& name, const Case& entry,
                        const AskAgain& again = nullptr);

  /// Puts an entry of which it is not known whether it shows the failure that it says. An entry
  /// that says the same of the same query takes it in. Else it goes under its address. Errors: as
  /// put.
  Result<Put> put_aside(const Failure& failure, const Case& entry, const AskAgain& again = nullptr);

  /// The failures of an entry of another folder need no find here. Requires that its id is the path
  /// of its file, and that no other thread uses the store.
  void know(const NamedCase& entry);

  /// The smallest entry that says that it shows the failure. Errors: as put.
  Result<std::optional<NamedCase>> standing(const Failure& failure);

  /// An entry has turned out not to show the failure that it says: it is no longer the entry of
  /// that failure. If it is named by the failure, it is renamed to the address of its query.
  /// Errors: as put.
  Result<void> disown(const Failure& failure, const std::string& path);

  /// All entries, ordered by path; an empty folder is no error. Makes the folder again if it was
  /// removed.
  Result<std::vector<NamedCase>> load();

  /// The file of a failure's entry.
  std::string path_of(const Failure& failure) const;
  /// As Store::open was given it, in its normal spelling.
  const std::string& folder() const { return folder_; }

  /// How often the folder has turned out to be another one than before, as where it was removed and
  /// made again, which this does. What was stored in the old one is not in it. Errors: as put.
  Result<std::uint64_t> times_replaced();

 private:
  /// An entry of any other name that showed a failure when it was read.
  struct Named {
    Failure failure;
    Rank rank = {};
    std::string path = {};

    auto operator<=>(const Named&) const = default;
  };

  Store() = default;
  Result<FolderLock> enter();
  template <class Work>
  auto locked(const Work& work) -> decltype(work());
  Result<void> read_named();
  Result<std::optional<NamedCase>> named(const Failure& failure);
  Result<void> move_aside(const NamedCase& entry) const;
  Result<Put> put_locked(const Failure& failure, const Case& find, const AskAgain& again);
  Result<Put> put_at(const std::string& path, const Case& entry, const AskAgain& again);
  std::string path_of(const std::string& stem) const;

  std::string folder_;
  std::string home_;  ///< where entries are written; locked while that is done
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();  ///< guards all below
  Descriptor home_folder_;
  std::uint64_t times_replaced_ = 0;
  std::set<Named> named_;
};

/// Whether an entry at this path is named by a failure that it shows; if so, by which.
std::optional<Failure> named_by_failure(const NamedCase& entry);

}  // namespace ccdfuzz
