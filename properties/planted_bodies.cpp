#include "properties/planted_bodies.hpp"

#include "case/scale.hpp"
#include "certify/checker/check_case.hpp"
#include "files/case_json.hpp"
#include "method/method.hpp"
#include "method/plugin/feature_claims.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

void claim_planted_truth(const Case& known, CaseKind kind, const Features& needs) {
  const auto checked = check_case(known);
  CLAIM(checked.has_value());
  CLAIM(checked->collides() == (kind == CaseKind::kRP));
  CLAIM(is_binary32(known.query));
  const auto read = parse_case(to_json(known, JsonLayout::kOneLine), "drawn");
  CLAIM(read && *read == known);
  for (const MethodInfo& info : registered_methods()) {
    CLAIM(check_taken(info.spec, known.query).has_value() == has_all(info.features, needs));
  }
}

void claim_same_time(const Truth& one, const Truth& other) {
  CLAIM(one.collides == other.collides);
  if (!*one.collides) return;
  CLAIM(one.witness->t >= other.clear_until.value_or(0));
  CLAIM(other.witness->t >= one.clear_until.value_or(0));
}

}  // namespace ccdfuzz
