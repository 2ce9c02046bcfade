#include "hunt/breeder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "corpus/store.hpp"
#include "eval/horizons.hpp"
#include "fuzz/mutator/mutate.hpp"
#include "hunt/scale.hpp"

namespace ccdfuzz {

namespace {

constexpr size_t kMembers = 64;

}  // namespace

Breeder::Breeder(std::string method, std::uint64_t seed, std::optional<int> scale, Aim aim)
    : method_(std::move(method)),
      traceable_(make_tracer(method_).has_value()),
      scale_(scale),
      aim_(aim),
      random_(Random::keyed({seed, 0x6272656564})) {}  // "breed"

std::optional<double> Breeder::nearness(const WitnessedQuery& q, TracerSet& tracers) {
  const Trace& trace = tracers[method_].trace(q.query, q.witness(), {});
  if (trace.lost) return std::nullopt;
  if (trace.margin) tally_.margin = std::min(tally_.margin.value_or(~0ULL), trace.margin->ulps);
  if (aim_ == Aim::kNothing) return 0;
  // Methods that compare at the ends of windows tell by how much (slack); of the others it is the
  // time between the contact and what was excluded.
  if (trace.slack) return trace.slack->value;
  if (trace.margin) return std::log2(1 + static_cast<double>(trace.margin->ulps));
  return std::numeric_limits<double>::infinity();
}

void Breeder::add(const Case& known, TracerSet& tracers) {
  std::optional<WitnessedQuery> q = witnessed_query(known);
  if (!q || (scale_ && !is_within_scale(q->query, *scale_))) return;
  founders_.insert(content_address(known.query));
  // Founders that are lost are as good as any: half of their mutants are not.
  const double near = traceable_ ? nearness(*q, tracers).value_or(0) : 0;
  join({*std::move(q), near});
}

void Breeder::join(Member member) {
  if (members_.size() < kMembers) {
    members_.push_back(std::move(member));
    return;
  }
  const auto farthest = std::ranges::max_element(members_, {}, &Member::nearness);
  // The younger of equals stays, so that the population drifts.
  if (member.nearness <= farthest->nearness) *farthest = std::move(member);
}

const WitnessedQuery& Breeder::parent() {
  const Member& a = members_[random_.below(members_.size())];
  const Member& b = members_[random_.below(members_.size())];
  return a.nearness <= b.nearness ? a.q : b.q;
}

void Breeder::step(MethodSet& methods, TracerSet& tracers, const SearchOptions& search,
                   const std::function<void(const Case&, const Judged&)>& found) {
  if (members_.empty()) return;
  const WitnessedQuery& mother = parent();
  const WitnessedQuery& father = members_[random_.below(members_.size())].q;
  WitnessedQuery mutant = mutate(mother, father, random_);
  if (scale_ && !is_within_scale(mutant.query, *scale_)) return;
  ++tally_.mutants;
  const std::optional<double> near = traceable_ ? nearness(mutant, tracers) : std::nullopt;
  if (near) {
    join({std::move(mutant), *near});
    return;
  }
  const Case known = case_of(mutant);
  if (traceable_) {
    ++tally_.lost;
  } else {
    join({std::move(mutant), 0});
  }
  const CaseSize size = size_of(known.query);
  if (smallest_failure_ && !(size < *smallest_failure_)) return;
  for (const double factor : kHorizonFactors) {
    const std::optional<Case> asked = at_horizon(known, factor);
    if (!asked || (scale_ && !is_within_scale(asked->query, *scale_))) continue;
    const Judged judged = ask(methods[method_], *asked, search);
    if (!is_failure(judged.outcome) || founders_.contains(content_address(asked->query))) continue;
    smallest_failure_ = size;
    found(*asked, judged);
    return;
  }
}

}  // namespace ccdfuzz
