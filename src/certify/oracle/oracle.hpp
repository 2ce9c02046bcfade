#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "case/answer.hpp"
#include "case/case.hpp"
#include "case/search_options.hpp"

namespace ccdfuzz {

/// Limits of one decision. All but max_seconds are counts, so that a decision without it does not
/// depend on the machine.
struct OracleOptions {
  std::uint64_t max_pops = 100'000;        ///< for each search
  std::uint64_t max_bytes = 256 << 20;     ///< for each search's queue
  std::uint64_t max_tree_nodes = 250'000;  ///< for a miss tree that decides; others have a quarter
  /// Wall time of finding. What was found by then is checked and returned, if that takes no longer
  /// than this again.
  double max_seconds = SearchOptions::kNoTimeLimit;
  double (*clock)() = nullptr;  ///< as of SearchOptions
  /// A contact that is known already.
  std::optional<Witness> known = {};
  /// A time up to which absence of contact is wanted, if it can be had: an earlier claim, say.
  std::optional<Rational> wanted_clear = {};
  /// A direction from patch 1 to patch 2 that may keep bodies which turn apart all the time.
  std::optional<Vec3<Rational>> apart_along = {};
};

/// What the oracle found out. Every statement in truth has its certificate there, which the checker
/// accepted. For collides = true it is a witness or contact box; for collides = false a clearance
/// that covers [0, t_max]; for clear_until a clearance. Where collides is absent it is undecided at
/// this resolution.
struct Decision {
  Truth truth;
  std::array<Uv<double>, 2> uv{};  ///< collides: of the contact
  std::uint64_t pops = 0;
  std::string note;  ///< why it is undecided
};

/// The note where max_seconds are over.
inline constexpr const char* kOutOfTime = "time budget exhausted";

/// Makes a truth say what its certificates prove of a query: collides, clear_until and the word for
/// the proof.
void conclude(const Query& query, Truth& truth);

/// Decides a query and proves the decision. tdibm-c finds what is to be proven, and tdibm-rational
/// where that stays undecided. A contact is proven by W or M, absence by P or T. Linear queries are
/// decided exactly (decide_linear), by W or R and L. With trims that may leave a query to the
/// others. Bodies are decided by W and K (decide_bodies), and those that turn by W and N
/// (decide_turning). Both are always sought: the earliest contact, and the latest time before it
/// that is clear. A query that is not valid stays undecided, with what is wrong with it as the
/// note. Keeps two solvers for each thread that asked, each at most kKeptBytes.
Decision decide(const Query& query, const OracleOptions& options = {});

/// What a tree proves of a valid query of patches: that nothing touches in [0, t_max]. Nothing
/// where building and checking it takes more than some 10 ms.
Truth absence_by_tree(const Query& query);

/// Whether linear arithmetic decides a query of patches, which is about whole ones.
bool is_decided_linearly(const Query& query);
/// Whether exact arithmetic decides a query, but for limits: that, or bodies.
bool is_decided_exactly(const Query& query);

/// decide as a method. toi is the certified clear time: no contact comes before it. What is no
/// question (is_question) is refused.
class Oracle {
 public:
  Answer answer(const Query& query, const SearchOptions& options);
};

}  // namespace ccdfuzz
