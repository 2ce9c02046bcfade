#pragma once

#include <cstdint>

#include "case/answer.hpp"
#include "ccd/certified/pair_split.hpp"
#include "ccd/search.hpp"

namespace ccdfuzz {

/// tdibm-c: the certified method (DERIVATION.md, "tdibm-c").
///
/// Never misses: a pair of cells is dropped, and a window shortened, only where an axis separates
/// the two control nets with a margin above the error bound at both ends of the dropped time
/// interval; by convexity it then separates them throughout. So
///   miss       no contact in [0, t_max], for every valid query;
///   hit        a pair of cells no wider than `precision` could not be separated at toi; every
///              contact is at toi or later;
///   undecided  a budget ran out; every contact is at toi or later;
///   refused    the query is not valid, or an option is out of range (is_taken); any bits may be
///              asked about.
/// How early toi can be: no later time is certified clear for that pair, so it is early by at most
/// the time in which the pair's hulls, of diameter O(precision), approach each other.
/// Linear patches (can_advance) are decided exactly: a hit is a contact, at toi + precision·t_max
/// at most. Where numbers differ by too many binary places (first_linear_contact), what is said
/// above holds for the patches as they are, and the answer's note says so.
/// Keeps at most kKeptBytes between queries.
class TdibmC {
 public:
  Answer answer(const Query& query, const SearchOptions& options);

  /// How many linear queries doubles left to integers, over the life of the object.
  std::uint64_t decided_in_integers() const { return decided_in_integers_; }

 private:
  struct Entry {
    Window window;
    certified::Axis hint;  ///< the axis that did most for the parent
    std::uint64_t key;     ///< start of the window in steps of kTimeSteps, then order of arrival
    std::array<certified::PairSplit::Node, 2> cells;
    std::uint32_t steps;
    std::uint16_t depth;

    static bool later(const Entry& x, const Entry& y);
  };

  Answer decide(const Query& query, const SearchOptions& options);
  void push(const certified::PairSplit::Kept& pair, int depth);
  double earliest(double so_far) const;
  std::uint64_t bytes() const { return queue_.bytes() + split_.bytes(); }

  certified::PairSplit split_;
  SearchQueue<Entry> queue_;
  std::uint64_t pushed_ = 0;
  std::uint64_t decided_in_integers_ = 0;
};

}  // namespace ccdfuzz
