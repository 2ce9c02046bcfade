#include "certify/checker/check_witness.hpp"

#include <fmt/format.h>

#include "certify/checker/abbreviated.hpp"
#include "certify/checker/check_bodies.hpp"
#include "certify/checker/check_trim.hpp"
#include "certify/checker/polar.hpp"

namespace ccdfuzz {

namespace {

tl::unexpected<InputError> refuse(const char* field, std::string what) {
  return input_error(fmt::format("truth.witness.{}", field), std::move(what));
}

/// S(u, v) at time t, by the checker's own blossom.
Vec3<Rational> point_at(const MovingPatch<double>& patch, const Uv<Rational>& uv, const Rational& t,
                        Work& work) {
  const auto [u, v] = std::array{uv[0], uv[1]};
  const Rational zero(0), rest_u(1 - u), rest_v(1 - v), rest(1 - u - v);
  const bool triangle = patch.shape.kind == ShapeKind::kTriangle;
  const std::vector<Weights<Rational>> first(
      static_cast<size_t>(patch.shape.n),
      triangle ? Weights<Rational>{rest, u, v} : Weights<Rational>{rest_u, u, zero});
  const std::vector<Weights<Rational>> second(static_cast<size_t>(patch.shape.m),
                                              Weights<Rational>{rest_v, v, zero});
  Polar<Rational> polar(&work, patch.is_rational());
  const Moving<Rational>& at = polar(patch.shape, moving_net<Rational>(patch), first, second);
  Vec3<Rational> point(at[0] + t * at[3], at[1] + t * at[4], at[2] + t * at[5]);
  if (!patch.is_rational()) return point;
  for (Rational& x : point) {
    work.charge(fraction_work(words_of(x) + words_of(at[kWeight])));
    x /= at[kWeight];
  }
  return point;
}

}  // namespace

Result<void> check_contact(const Query& query, const Witness& witness, std::uint64_t most_work) {
  if (is_of_bodies(query)) return check_body_contact(query, witness, most_work);
  if (!witness.weights[0].empty() || !witness.weights[1].empty()) {
    return refuse("weights", "are of bodies alone");
  }
  if (witness.t < 0) return refuse("t", fmt::format("{} is negative", abbreviated(witness.t)));
  return within_work("truth.witness", most_work, [&](Work& work) -> Result<void> {
    std::array<Vec3<Rational>, 2> at;
    for (size_t s = 0; s < 2; ++s) {
      const MovingPatch<double>& patch = query.patches[s];
      if (!patch.shape.contains(witness.uv[s])) {
        return refuse("uv", fmt::format("({}, {}) lies outside the domain of patches[{}], {}",
                                        abbreviated(witness.uv[s][0]),
                                        abbreviated(witness.uv[s][1]), s, to_text(patch.shape)));
      }
      if (!is_in_region(patch.trim, witness.uv[s], work)) {
        return refuse("uv",
                      fmt::format("({}, {}) lies outside of the trim of patches[{}]",
                                  abbreviated(witness.uv[s][0]), abbreviated(witness.uv[s][1]), s));
      }
      at[s] = point_at(patch, witness.uv[s], witness.t, work);
    }
    if (query.separation > 0) {
      Rational squared = 0;
      for (const int k : {0, 1, 2}) {
        const Rational way = at[0][k] - at[1][k];
        work.charge(fraction_work(2 * words_of(way)));
        squared += way * way;
      }
      if (squared <= exact(query.separation) * exact(query.separation)) return {};
      return refuse("uv", fmt::format("the points are farther apart than {}: {} squared",
                                      query.separation, abbreviated(squared)));
    }
    for (int k = 0; k < 3; ++k) {
      if (at[0][k] == at[1][k]) continue;
      return refuse("uv", fmt::format("the patches do not touch there: coordinate {} is {} and {}",
                                      "xyz"[k], abbreviated(at[0][k]), abbreviated(at[1][k])));
    }
    return {};
  });
}

Result<void> check_witness(const Query& query, const Witness& witness, std::uint64_t most_work) {
  if (witness.t > exact(query.t_max)) {
    return refuse("t", fmt::format("{} is after t_max = {}", abbreviated(witness.t), query.t_max));
  }
  return check_contact(query, witness, most_work);
}

}  // namespace ccdfuzz
