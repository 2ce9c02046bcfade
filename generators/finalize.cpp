#include "generators/finalize.hpp"

#include "base/verify.hpp"
#include "bezier/exact_patch.hpp"
#include "certify/checker/check_witness.hpp"

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

void say_clear(Case& value, double t_max) {
  value.query.t_max = t_max;
  Truth& truth = value.truth;
  truth.collides = false;
  truth.witness.reset();
  const bool is_certified = truth.clearance && covers(*truth.clearance, exact(t_max));
  truth.proof = is_certified ? proof_word(*truth.clearance) : "rational-tdibm";
}

Case finalize(const Scene& scene, const Query& query, CaseKind kind,
              const std::optional<Absence>& clear) {
  Case result;
  result.query = query;
  // These kinds stand or fall with the contact, so the checker sees it before any is let out; but a
  // near-miss has none.
  const Witness witness{scene.contact.t.rational(),
                        {uv_of(scene.contact.x[0]), uv_of(scene.contact.x[1])}};
  CCDFUZZ_VERIFY(kind == CaseKind::kNMN || check_witness(query, witness));
  if (clear) {
    result.truth.clear_until = clear->until.rational();
    if (clear->plane) result.truth.clearance = *clear->plane;
  }
  if (kind == CaseKind::kRP || kind == CaseKind::kNHP) {
    result.truth.collides = true;
    result.truth.witness = witness;
  } else {
    CCDFUZZ_VERIFY(clear);
    const std::optional<double> t_max = clear->until.to_double_exactly();
    CCDFUZZ_VERIFY(t_max);  // t* is a multiple of 2^-3 in (0, 1], eps_T at least 2^-40
    say_clear(result, *t_max);
  }
  return result;
}

}  // namespace ccdfuzz
