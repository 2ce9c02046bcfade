#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "finds/minimise.hpp"
#include "finds/store.hpp"

namespace ccdfuzz {

/// The find that a run has kept for one failure.
struct Find {
  Failure failure = {};
  std::string path = {};  ///< where it is; empty if it could not be stored
  Case value = {};        ///< with its expectations
  bool is_new = false;    ///< found by this run; else it was there before, or a smaller one was
  Judged judged = {};     ///< the answer to a new one that is no error, with its depth_of
  /// The method shows something else of a new one, asked again (Asker::differs).
  bool differs = false;
  bool cut_short = false;  ///< there was no time to minimise it to the end
};

/// The finds of one run on their way into a store. The smallest of each failure is kept in memory,
/// so that none is lost while the store cannot be written, or with its folder. Whenever one is to
/// be stored, all that are not in the store are. What a stored entry says of itself hides no find.
/// Where it would, its method is asked again, and it is disowned if it does not fail so. Safe from
/// several threads.
class Intake {
 public:
  /// What asks a method about a stored entry; and what shrinks and asks others, one a thread.
  using MakeAsker = std::function<Asker()>;

  /// confirm: asks methods about stored entries, in children, since an entry may be anything.
  Intake(Store& store, MakeAsker make, const MakeAsker& confirm)
      : store_(store), make_(std::move(make)), confirm_(confirm()) {}

  /// A case shows a failure. Keeps and stores it if it is the smallest so far, with the version
  /// that a plug-in says of itself and what was judged (say_version). What goes wrong with the
  /// store is trouble. Returns true iff the failure was offered for the first time and is not in
  /// the store.
  bool offer(const Failure& failure, Case find, const Judged& judged = {});

  /// Puts an entry of another folder: for the failure that it is named by, or under its own name.
  /// If its query is there, the two become one, and what they disagree about the
  /// methods are asked. One whose method, when it is asked, does not fail as the name says waits
  /// for take_doubtful. If another find is stored for that failure, the smaller one stays. An entry
  /// whose method was not admitted is then kept beside it, named by the address of its query.
  /// Errors: of the store.
  Result<Store::Put> take(const NamedCase& entry);
  /// Puts the entries that wait under the address of their query, or into one of that query that
  /// stands for their failure. Returns how many changed the store. Errors: as take, and of reading.
  Result<std::uint64_t> take_doubtful();

  /// How often a method was asked where entries disagreed. And, for each method that could not be
  /// asked, how often the stored outcome was kept.
  struct Settled {
    std::uint64_t asked = 0;
    std::map<std::string, std::uint64_t> kept;
  };
  const Settled& settled() const { return settled_; }

  /// True iff the failure was offered, or an entry says that it shows it, and does when its method
  /// is asked again. Errors: of the store.
  Result<bool> has(const Failure& failure);

  /// Stores all that is kept and not in the store. Errors: of the store; nothing is forgotten then.
  Result<void> store_all();

  struct Finish {
    int threads = 1;
    /// Whether to minimise the find of a failure; and what it stays within, as MinimiseOptions.
    std::function<bool(const Failure&)> shrinks;
    std::function<bool(const Case&)> admits;
    /// For all of them. Each find gets an equal share of what is left when its turn comes.
    std::function<double()> seconds_left;
    /// The methods that each find is to say what it expects of.
    std::vector<std::string> methods;
    /// True ends it.
    const std::atomic<bool>& stop;
  };
  /// Minimises the new finds and asks all methods about them. Errors: of the store; throws
  /// NoProcess where a method does, unless stop is true.
  Result<void> finish(const Finish& how);

  /// The first thing that went wrong with the store, if anything did.
  std::optional<InputError> trouble() const;
  /// How many new finds there are.
  size_t count() const;
  /// All that was offered, ordered by failure.
  std::vector<Find> finds() const;

 private:
  struct Kept {
    Rank rank;
    Find find;
    bool stored = false;

    bool is_new() const { return find.is_new || !stored; }
  };

  void keep(Find find, Rank rank);
  static void complete(Find& find, Asker& asker, const Finish& how, double seconds);
  Result<void> store_kept();
  Result<Store::Put> put(const Failure& failure, const Case& find, const AskAgain& again = nullptr);
  Result<Store::Put> put_aside(const NamedCase& entry, const Failure& failure);
  AskAgain again();
  bool fails_so(const NamedCase& entry, const Failure& failure);
  Result<std::optional<bool>> confirm_standing(const Failure& failure);
  Result<void> notice_replacement();
  Result<void> noted(Result<void> result);

  Store& store_;
  MakeAsker make_;
  mutable std::mutex mutex_;
  Asker confirm_;
  std::map<Failure, Kept> kept_;
  std::set<Failure> confirmed_;        ///< an entry that the store knows shows it
  std::vector<std::string> doubtful_;  ///< the paths of the entries that wait
  Settled settled_;
  std::uint64_t times_replaced_ = 0;
  std::optional<InputError> trouble_;
};

}  // namespace ccdfuzz
