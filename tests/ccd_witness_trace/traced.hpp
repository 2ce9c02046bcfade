#pragma once

#include <array>
#include <string>

#include "ccd/witness_trace/trace.hpp"
#include "generators/generate.hpp"
#include "meeting_points.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

inline constexpr std::array kTraceable = {
    "trad",    "trad:aabb",       "tdibm",          "tdibm-h:1e-12", "tdibm-h:1e-12@absolute",
    "tdibm-e", "tdibm-e-literal", "tdibm-rational", "tdibm-c"};
/// Those whose miss is a proof, here and everywhere.
inline constexpr std::array kSound = {"tdibm-rational", "tdibm-c"};

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
