#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ccd/witness_trace/trace.hpp"
#include "finds/content_address.hpp"
#include "hunt/ground.hpp"
#include "hunt/population.hpp"
#include "method/ask.hpp"

namespace ccdfuzz {

/// The counts of breeding.
struct BreedTally {
  /// Traced ones; where mutants have no trace, those that the method was asked about and took.
  std::uint64_t mutants = 0;
  std::uint64_t lost = 0;  ///< those whose contact the method lost on the way
  /// By how many ulps the contacts that were not lost survived (Trace::Margin), the least of it.
  /// Founders count, too.
  std::optional<std::uint64_t> margin;
};

/// How parents are chosen.
enum class Aim : std::uint8_t {
  kMargins,  ///< how nearly the method lost the contact, in each niche
  kNothing,  ///< chance: for comparison
};

/// Searches for counterexamples to one method by mutating cases with a known contact. Every mutant
/// keeps an exact witness, so its truth needs no new proof. A trace takes microseconds, so
/// thousands of mutants cost as much as a few queries. Parents come from two populations, equally
/// often:
///   nearest   per niche, the contact that the method came closest to losing, by its trace
///   drifting  each mutant that keeps its contact replaces a random member
///
/// If a trace loses its contact and the mutant is smaller than every failure before, the method is
/// asked up to the contact and past it. A failure there is a counterexample, unless the moves led
/// back to a founder, which is asked elsewhere. A plug-in cannot be traced: it is asked about every
/// smaller mutant, and the drifting population alone is used. So it is with bodies, and with linear
/// patches in floats, in which no exact witness stays. The truth of their mutants is decided anew.
class Breeder {
 public:
  Breeder(std::string method, std::uint64_t seed, const HuntGround& ground = {},
          Aim aim = Aim::kMargins);

  /// A case joins the population, if it has a dyadic witness within its t_max.
  void add(const Case& known, MethodSet& methods);

  /// Makes one mutant and traces it. found(Case, Judged): a counterexample.
  void step(MethodSet& methods, const SearchOptions& search,
            const std::function<void(const Case&, const Judged&)>& found);

  const BreedTally& tally() const { return tally_; }
  /// Nothing to make mutants of, yet.
  bool empty() const { return drifting_.empty() && queries_.empty(); }

 private:
  /// Whether the method keeps the contact; if so, the nearest to a loss are remembered.
  bool trace_and_note(const Contact& q, MethodSet& methods);
  /// Whether it lies on the ground and the method takes it.
  bool is_for_it(const Query& query) const;
  const Contact& mother();
  /// Whether mutants of such a query have their truth decided, rather than kept.
  bool decides_anew(const Query& query) const;
  std::optional<Case> decided_mutant();
  /// Unless it is no smaller than a failure. Returns whether the method took it.
  bool ask_about(const Case& made, MethodSet& methods, const SearchOptions& search,
                 const std::function<void(const Case&, const Judged&)>& found);

  std::string method_;
  bool traceable_;
  Features features_;
  HuntGround ground_;
  Aim aim_;
  Draw random_;
  Population nearest_;
  std::vector<Contact> drifting_;
  std::vector<Query> queries_;      ///< those of decides_anew; they drift, too
  std::set<std::string> founders_;  ///< addresses
  std::optional<CaseSize> smallest_failure_;
  BreedTally tally_;
};

}  // namespace ccdfuzz
