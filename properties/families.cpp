#include "certify/checker/check_truth.hpp"
#include "generators/generate.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Case draw_not_plain(Draw& d, CaseKind kind) {
  GeneratorOptions options;
  options.family = d.pick(kNotPlainFamilies);
  options.contact = d.pick(kContactClasses);
  options.kind = kind;
  options.proof_pops = 1000;
  suppose(is_made(options.family, options.contact, kind));
  return generate(options, d).value;
}

Case draw_not_plain_contact(Draw& d) {
  return draw_not_plain(d, CaseKind::kRP);
}

void check_truths(Draw& d) {
  const CaseKind kind = d.coin() ? CaseKind::kRN : CaseKind::kRP;
  const Case made = draw_not_plain(d, kind);
  show(d, "case", made);
  const Result<void> checked = check_truth(made);
  show(d, "truth", checked);
  CLAIM(checked.has_value());
  const Truth& truth = made.truth;
  CLAIM(truth.collides == (kind == CaseKind::kRP));
  if (!truth.clearance) return;
  CLAIM(check_clearance(made.query, *truth.clearance, "").has_value());
}

}  // namespace

std::vector<Property> families_claims() {
  std::vector<Property> claims = {
      {"generator.not_plain", "Cases of weights, loops, ends and separations are what they say",
       "generators/generate.hpp", check_truths},
  };
  add_contact_claims(claims, "not_plain", "of weights, loops, ends and separations",
                     {"src/ccd/certified/DERIVATION.md", "src/ccd/rational/DERIVATION.md"},
                     draw_not_plain_contact);
  return claims;
}

}  // namespace ccdfuzz
