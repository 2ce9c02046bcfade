#pragma once

#include <cstdint>

#include "case/answer.hpp"
#include "ccd/certified/pair_split.hpp"
#include "ccd/search.hpp"

namespace ccdfuzz {

/// tdibm-c: the certified method (DERIVATION.md).
///
/// Read next: PairSplit (the test of a pair), window_trim.hpp (Laws A and B, how a window shrinks),
/// projection.hpp (Law C, the error bound), normalise.hpp. For linear queries, in the order in
/// which they are asked: linear_advance.hpp (Laws A and C), rough_contact.hpp (Law L9),
/// linear_contact.hpp (Laws L1 to L8). Those on doubles need rounding to nearest, without FTZ and
/// DAZ: answer sees to that (FpGuard).
///
/// Never misses: the general search drops a pair of cells, or a part of a window, only with
/// a separating axis, or outside of a patch's loops (below). On the axis the two control nets are
/// apart by more than the error bound at an end of the window (Law C). At both ends, convexity
/// gives the time between (Law A). At one, h is below the chord of its upper bounds, so negative up
/// to the chord's root (Law B). Linear queries exclude times by signs of polynomials, too. So
///   miss       no contact in [0, t_max], for every valid query;
///   hit        a pair of cells no wider than max(precision, 2^-50) could not be separated in its
///              window, which begins at toi or at most 2^-20·t_max later; every contact is at toi
///              or later;
///   undecided  a budget ran out; every contact is at toi or later;
///   refused    the query is not valid, or an option is out of range (is_taken). Any bits may be
///              passed, NaN and infinity too.
/// How early toi can be: no time after the begin of that window is certified clear for the pair. So
/// toi is early by at most 2^-20·t_max and the time in which the pair's hulls approach each other.
/// They are O(precision + E) apart then, E the error bound of Law C.
/// With the precision 1 such a pair is of halves, as no axis is put to whole patches.
/// A pair of a trimmed patch is dropped, too, where a cell has no point in the closed region of its
/// loops, which is decided exactly. So no cell of a hit is known to be outside, but uv may be.
/// Linear patches (is_linear_pair) that are not trimmed are decided exactly: a hit is a contact, at
/// most max(precision, 2^-43)·t_max after toi. A subnormal toi is rounded down besides.
/// Where numbers differ by too many binary places, or roots by too few (first_linear_contact), only
/// what is said above holds. The answer's note says so then.
/// With a separation d all of this is said of distances. A miss is a distance above d throughout.
/// That a hit's cells are about as near as d is tested (separation.not_early), but not proven.
/// A hit on linear patches without pops is decided as far as doubles tell the distance from d: to
/// 2^-42 of the largest coordinate between 0 and t_max (tdibm-c.linear_near_misses). With pops,
/// which patches that turn may take, it is as near as any other hit. Keeps at most kKeptBytes
/// between queries. A law's tests are named by it in tests/ccd_certified.
class TdibmC {
 public:
  Answer answer(const Query& query, const SearchOptions& options);

  /// How often each tier decided, over the life of the object.
  const certified::Tiers& tiers() const { return split_.tiers(); }

 private:
  struct Entry : certified::CellPair {
    std::uint16_t depth;        ///< both cells together
    std::uint32_t time_bucket;  ///< start of the window in units of t_max·2^-20, rounded down
    std::uint64_t order;        ///< when it came, among the others

    /// The order of the queue: by bucket, in one bucket deeper pairs first, then as they came.
    static bool later(const Entry& x, const Entry& y);
  };
  static_assert(sizeof(Entry) == 64);

  Answer decide(const Query& query, const SearchOptions& options);
  /// What the linear patches of split_ show: by Laws A and C, then, without a separation, by Laws
  /// L9 and L1 to L8. Returns nullopt where the general search must decide, which may then begin at
  /// `from`.
  std::optional<Answer> decide_linear(const Query& query, const SearchOptions& options, int target,
                                      double& from);
  void push(const certified::CellPair& pair);
  double earliest(double so_far) const;
  std::uint64_t bytes() const { return queue_.bytes() + split_.bytes(); }

  certified::PairSplit split_;
  SearchQueue<Entry> queue_;
  std::uint64_t pushed_ = 0;
};

}  // namespace ccdfuzz
