#include "certify/checker/check_witness.hpp"

#include <fmt/format.h>

#include "bezier/blossom.hpp"

namespace ccdfuzz {

namespace {

tl::unexpected<InputError> refuse(const char* field, std::string what) {
  return input_error(fmt::format("truth.witness.{}", field), std::move(what));
}

}  // namespace

Result<void> check_contact(const Query& query, const Witness& witness) {
  if (witness.t < 0) return refuse("t", fmt::format("{} is negative", to_text(witness.t)));
  std::array<Vec3<Rational>, 2> at;
  for (size_t s = 0; s < 2; ++s) {
    const MovingPatch<double>& patch = query.patches[s];
    if (!patch.shape.contains(witness.uv[s])) {
      return refuse("uv", fmt::format("({}, {}) lies outside the domain of patches[{}], {}",
                                      to_text(witness.uv[s][0]), to_text(witness.uv[s][1]), s,
                                      to_text(patch.shape)));
    }
    at[s] = evaluate(exact_patch<Rational>(patch), witness.uv[s], witness.t);
  }
  for (int k = 0; k < 3; ++k) {
    if (at[0][k] != at[1][k]) {
      return refuse("uv", fmt::format("the patches do not touch there: coordinate {} is {} and {}",
                                      "xyz"[k], to_text(at[0][k]), to_text(at[1][k])));
    }
  }
  return {};
}

Result<void> check_witness(const Query& query, const Witness& witness) {
  if (witness.t > exact(query.t_max)) {
    return refuse("t", fmt::format("{} is after t_max = {}", to_text(witness.t), query.t_max));
  }
  return check_contact(query, witness);
}

}  // namespace ccdfuzz
