#include "hunt/breeder.hpp"

#include <algorithm>

#include "corpus/store.hpp"
#include "eval/horizons.hpp"
#include "fuzz/mutator/mutate.hpp"
#include "hunt/scale.hpp"

namespace ccdfuzz {

namespace {

/// Of the population whose members nobody compares.
constexpr std::uint64_t kPlaces = 64;

}  // namespace

Breeder::Breeder(std::string method, std::uint64_t seed, std::optional<int> scale, Aim aim)
    : method_(std::move(method)),
      traceable_(make_tracer(method_).has_value()),
      scale_(scale),
      aim_(aim),
      random_(Random::keyed({seed, 0x6272656564})) {}  // "breed"

bool Breeder::keeps(const WitnessedQuery& q, TracerSet& tracers) {
  const Trace& trace = tracers[method_].trace(q.query, q.witness(), {});
  if (trace.lost) return false;
  if (trace.margin) tally_.margin = std::min(tally_.margin.value_or(~0ULL), trace.margin->ulps);
  if (aim_ == Aim::kMargins) nearest_.join(q, standing_of(q, trace));
  return true;
}

void Breeder::drift(WitnessedQuery q) {
  const auto place = static_cast<std::int16_t>(random_.below(kPlaces));
  drifting_.join(std::move(q), {{Niche::By::kNothing, 0, place}, 0});
}

void Breeder::add(const Case& known, TracerSet& tracers) {
  std::optional<WitnessedQuery> q = witnessed_query(known);
  if (!q || (scale_ && !is_within_scale(q->query, *scale_))) return;
  founders_.insert(content_address(known.query));
  if (traceable_) keeps(*q, tracers);
  // Founders that are lost are as good as any: half of their mutants are not.
  drift(*std::move(q));
}

const WitnessedQuery& Breeder::mother() {
  const bool by_margin = !nearest_.empty() && random_.below(2) == 0;
  return by_margin ? nearest_.nearer_of_two(random_) : drifting_.any(random_);
}

void Breeder::step(MethodSet& methods, TracerSet& tracers, const SearchOptions& search,
                   const std::function<void(const Case&, const Judged&)>& found) {
  if (drifting_.empty()) return;
  const WitnessedQuery& first = mother();
  WitnessedQuery mutant = mutate(first, drifting_.any(random_), random_);
  if (scale_ && !is_within_scale(mutant.query, *scale_)) return;
  ++tally_.mutants;
  if (traceable_ && keeps(mutant, tracers)) {
    drift(std::move(mutant));
    return;
  }
  const Case known = case_of(mutant);
  if (traceable_) {
    ++tally_.lost;
  } else {
    drift(std::move(mutant));
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
