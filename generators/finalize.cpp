#include "generators/finalize.hpp"

#include "base/verify.hpp"
#include "bezier/exact_patch.hpp"
#include "certify/checker/check_witness.hpp"
#include "generators/first_contact.hpp"

namespace ccdfuzz {

std::optional<Query> to_query(const Scene& scene) {
  Query query;
  for (size_t s = 0; s < 2; ++s) {
    const auto patch = to_doubles(scene.patches[s]);
    if (!patch) return std::nullopt;
    query.patches[s] = *patch;
  }
  const std::optional<double> t_max = scene.t_max.to_double_exactly();
  if (!t_max) return std::nullopt;
  query.t_max = *t_max;
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
  if (!miss_is_proven(value.query, options.proof_pops)) {
    return tl::unexpected(Discard::kFirstContact);
  }
  say_clear(value, t_max);
  value.truth.clear_until = exact(t_max);
  return value;
}

}  // namespace ccdfuzz
