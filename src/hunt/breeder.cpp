#include "hunt/breeder.hpp"

#include <algorithm>

#include "certify/checker/check_case.hpp"
#include "certify/oracle/oracle.hpp"
#include "eval/horizons.hpp"
#include "fuzz/mutator/mutate.hpp"
#include "fuzz/mutator/mutate_query.hpp"
#include "method/plugin/feature_claims.hpp"
#include "method/taken_query.hpp"

namespace ccdfuzz {

namespace {

/// Members of the population that drifts. A draw adds up to four: so that it replaces few.
constexpr size_t kDrifting = 64;

template <class Member>
void drift(std::vector<Member>& members, Member next, Draw& random) {
  if (members.size() < kDrifting) {
    members.push_back(std::move(next));
  } else {
    members[random.below(kDrifting)] = std::move(next);
  }
}

}  // namespace

Breeder::Breeder(std::string method, std::uint64_t seed, const HuntGround& ground, Aim aim)
    : method_(std::move(method)),
      traceable_(value_or_throw(make_method(method_))->is_traceable()),
      features_(value_or_throw(method_info(method_)).features),
      ground_(ground),
      aim_(aim),
      random_(Random::keyed({seed, 0x6272656564})) {}  // "breed"

bool Breeder::trace_and_note(const Contact& q, MethodSet& methods) {
  const Trace& trace = methods[method_].trace(q.query, q.witness(), {});
  if (trace.lost) return false;
  if (trace.margin) tally_.margin = std::min(tally_.margin.value_or(~0ULL), trace.margin->ulps);
  if (aim_ == Aim::kMargins) nearest_.join(q, standing_of(q, trace));
  return true;
}

bool Breeder::is_for_it(const Query& query) const {
  return ground_.has(query) && TakenQuery(query, features_).query() != nullptr;
}

void Breeder::add(const Case& known, MethodSet& methods) {
  if (decides_anew(known.query)) {
    // One that touches at 0 has no mutants (decided_mutant).
    if (!is_for_it(known.query) || known.truth.contact_by() == Rational(0)) return;
    founders_.insert(content_address(known.query));
    return drift(queries_, known.query, random_);
  }
  std::optional<Contact> q = contact_of(known);
  if (!q || !is_for_it(q->query)) return;
  founders_.insert(content_address(known.query));
  // Founders that are lost are as good as any: half of their mutants are not.
  if (traceable_) trace_and_note(*q, methods);
  drift(drifting_, *std::move(q), random_);
}

const Contact& Breeder::mother() {
  const bool by_margin = !nearest_.empty() && random_.below(2) == 0;
  return by_margin ? nearest_.nearer_of_two(random_) : drifting_[random_.below(drifting_.size())];
}

bool Breeder::decides_anew(const Query& query) const {
  const bool is_rounded = ground_.binary32 || is_kept(query.separation, features_);
  return is_of_bodies(query) || (is_rounded && !traceable_ && is_decided_linearly(query));
}

/// A mutant that is apart at the start, with its truth; three in four that then miss do not drift.
std::optional<Case> Breeder::decided_mutant() {
  const Query& first = queries_[random_.below(queries_.size())];
  const Query& other = queries_[random_.below(queries_.size())];
  Case changed;
  changed.query = mutate_query(first, other, random_);
  const Query mutant = ground_.fitted(std::move(changed)).query;
  if (!is_for_it(mutant)) return std::nullopt;
  std::optional<Case> made = decided_case(mutant);
  if (!made || made->truth.contact_by() == Rational(0)) return std::nullopt;
  if (*made->truth.collides || random_.below(4) == 0) drift(queries_, mutant, random_);
  return made;
}

void Breeder::step(MethodSet& methods, const SearchOptions& search,
                   const std::function<void(const Case&, const Judged&)>& found) {
  if (!queries_.empty() && (drifting_.empty() || random_.coin())) {
    const std::optional<Case> made = decided_mutant();
    if (made && ask_about(*made, methods, search, found)) ++tally_.mutants;
    return;
  }
  if (drifting_.empty()) return;
  const Contact& first = mother();
  const bool takes_all = has_all(features_, kPatchFeatures);
  Contact mutant = mutate(first, drifting_[random_.below(drifting_.size())], random_,
                          takes_all ? QueryRange::kAll : QueryRange::kPlain);
  if (!is_for_it(mutant.query)) return;
  if (traceable_) ++tally_.mutants;
  const bool is_lost = traceable_ && !trace_and_note(mutant, methods);
  if (is_lost) ++tally_.lost;
  // What cannot be traced is asked about, and drifts.
  std::optional<Case> asked;
  if (is_lost || !traceable_) asked = case_of(mutant);
  if (!is_lost) drift(drifting_, std::move(mutant), random_);
  const bool is_taken = asked && ask_about(*asked, methods, search, found);
  if (is_taken && !traceable_) ++tally_.mutants;
}

bool Breeder::ask_about(const Case& made, MethodSet& methods, const SearchOptions& search,
                        const std::function<void(const Case&, const Judged&)>& found) {
  const CaseSize size = size_of(made.query);
  if (smallest_failure_ && !(size < *smallest_failure_)) return false;
  const CheckedCase known = checked_or_unknown(made);
  bool answered = false;
  for (const CheckedCase& asked : forms_of(known)) {
    if (!ground_.has(asked.value())) continue;
    const Judged judged = ask(methods[method_], asked, search);
    answered |= judged.outcome != Outcome::kNotAsked;
    const bool founds = founders_.contains(content_address(asked.query()));
    if (!is_failure(judged.outcome) || founds) continue;
    smallest_failure_ = size;
    found(asked.value(), judged);
    return true;
  }
  return answered;
}

}  // namespace ccdfuzz
