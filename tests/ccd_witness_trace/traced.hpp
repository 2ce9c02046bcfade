#pragma once

#include <string>
#include <vector>

#include "ccd/witness_trace/trace.hpp"
#include "generators/generate.hpp"
#include "meeting_points.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

/// Those whose miss is a proof everywhere; not the oracle, which is traced as tdibm-c.
inline const std::vector<std::string> kSound =
    every_method_but({"oracle"}, &MethodInfo::claim_is_proven);

inline std::unique_ptr<Method> tracer_of(const std::string& spec) {
  return value_or_throw(make_method(spec));
}

inline Witness at_time(const Rational& t) {
  Witness witness;
  witness.t = t;
  return witness;
}

inline Case generated_case(ContactClass contact, Family family, std::uint64_t index) {
  GeneratorOptions options{
      .contact = contact, .construction = Construction::kOneSided, .family = family, .seed = 1};
  return generate(options, index).value;
}

}  // namespace ccdfuzz
