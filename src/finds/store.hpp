#pragma once

#include <memory>
#include <string>
#include <vector>

#include "case/case_files.hpp"
#include "finds/content_address.hpp"
#include "finds/entries.hpp"
#include "finds/failure.hpp"

namespace ccdfuzz {

/// A folder of counterexamples, one readable .json file each, named by content_address, or by
/// origin.name where it has one.
///
/// Laws, with any number of threads and processes adding to one folder, and after SIGKILL at any
/// moment:
///  1. Every entry is whole.
///  2. For each failure_key (method, contact class, failure signature) the folder holds the
///  smallest case that
///     was added, by CaseSize and then by address; so what is kept does not depend on the order.
///  3. It holds no other for the same three, but for named entries, which are never taken away. (A
///     killed writer may leave the larger one beside the smaller; the next open takes it away.)
///  4. No entry's expectation is ever changed by another find.
class Store {
 public:
  enum class Added {
    kNew,      ///< first of at least one (method, class, signature)
    kSmaller,  ///< took the place of a larger entry for at least one
    kMerged,   ///< the query was there, and now holds further expectations
    kKnown,    ///< nothing new, nothing written
  };

  /// Opens a folder, making it if need be. If it has a sub-folder `regressions`, entries are
  /// written there, and those of all its sub-folders count as known.
  /// Errors: the folder cannot be made, read, written or locked; an entry in it cannot be read.
  static Result<Store> open(const std::string& folder);
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  /// Adds a case with its expectations, and makes the folder again if it was removed. A failure
  /// that a smaller entry stands for is dropped from it; a case without failures is known by its
  /// address alone. Safe from several threads. Errors: a refuted truth; a full disk or any other
  /// refusal of the system, after which the entries so far stand; an origin.name that is no file
  /// name or names another case. trees: the file of trees beside the case, of which its own comes
  /// along; without it (empty) what a tree proves is left out.
  Result<Added> add(const Case& find, const std::string& trees = "");

  /// Takes the failure of a method away from the entry of `larger`, and the entry if it then stands
  /// for none, where the entry of `simpler` stands for the same one of another kind or generator,
  /// which laws 2 and 3 tell apart: what two finds come down to is one entry, and has one origin.
  /// Nothing happens to named entries, or where either is not there. Errors: as add.
  Result<void> supersede(const Case& larger, const std::string& method, const Case& simpler);

  /// All entries, ordered by path; none is no error. Makes the folder again if it was removed.
  Result<std::vector<NamedCase>> load() const;

  /// As Store::open was given it, in its normal spelling.
  const std::string& folder() const;

  /// How often the folder has turned out to be another one than before, as where it was removed
  /// and made again: what was stored in the old one is not in it.
  std::uint64_t times_replaced() const;

 private:
  struct State;
  explicit Store(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace ccdfuzz
