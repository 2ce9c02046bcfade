#include "generators/finalize.hpp"

#include "base/verify.hpp"
#include "bezier/exact_patch.hpp"
#include "certify/checker/check_witness.hpp"
#include "generators/first_contact.hpp"

namespace ccdfuzz {

std::optional<Query> to_query(const std::array<MovingPatch<Dyadic>, 2>& patches,
                              const Dyadic& t_max) {
  Query query;
  for (size_t s = 0; s < 2; ++s) {
    const auto patch = to_doubles(patches[s]);
    if (!patch) return std::nullopt;
    query.patches[s] = *patch;
  }
  const std::optional<double> end = t_max.to_double_exactly();
  if (!end) return std::nullopt;
  query.t_max = *end;
  return query;
}

void say_contact(Case& value, const Witness& witness) {
  CCDFUZZ_VERIFY(check_witness(value.query, witness));
  value.truth.collides = true;
  value.truth.witness = witness;
}

void say_clear(Case& value, double t_max) {
  value.query.t_max = t_max;
  Truth& truth = value.truth;
  truth.collides = false;
  truth.witness.reset();
  const bool is_certified = truth.clearance && covers(*truth.clearance, exact(t_max));
  truth.proof = is_certified ? proof_word(*truth.clearance) : "rational-tdibm";
}

Attempted proven_apart(Case value, const GeneratorOptions& options) {
  const double t_max = value.query.t_max;
  if (!proven_by_search(value.query, Dyadic::exact(t_max), options.proof_pops)) {
    return tl::unexpected(Discard::kFirstContact);
  }
  say_clear(value, t_max);
  value.truth.clear_until = exact(t_max);
  return value;
}

}  // namespace ccdfuzz
