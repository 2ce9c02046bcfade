#include "certify/oracle/decide_linear.hpp"

#include <algorithm>

#include "base/verify.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/linear/first_contact.hpp"

namespace ccdfuzz {

namespace {

/// Narrows the contact's time until its polynomial proves the contact to the checker. It does in
/// the end: what is not 0 at the root has a sign by its Bernstein coefficients on a short interval.
/// Nothing if the time turns out to be rational.
std::optional<ContactRoot> provable_root(const Query& query, linear::RealRoot& time) {
  constexpr int kMostRounds = 64;
  for (int round = 0; round < kMostRounds && !time.is_rational(); ++round) {
    const ContactRoot root{time.polynomial().coefficients(), time.lo(), time.hi()};
    if (check_contact_root(query, root)) return root;
    time.narrow((time.hi() - time.lo()) * power_of_two(-64));
  }
  CCDFUZZ_VERIFY(time.is_rational());
  return std::nullopt;
}

}  // namespace

Decision decide_linear(const Query& query, const OracleOptions& options) {
  const Rational t_max = exact(query.t_max);
  Rational until = t_max;
  if (options.wanted_clear) until = std::max(until, *options.wanted_clear);
  if (options.known) until = std::max(until, options.known->t);
  const std::array<MovingPatch<Rational>, 2> patches = linear::exact_patches(query);
  Decision out;
  Truth& truth = out.truth;
  auto contact = linear::first_contact(patches, until);
  if (!contact) {
    truth.clearance = LinearClearance{until, true};
  } else {
    linear::RealRoot& time = contact->time;
    time.narrow(until * power_of_two(-64));
    // So that t_max is no longer in the enclosure.
    time.sign_of(linear::Polynomial({-t_max.get_num(), t_max.get_den()}));
    truth.contact_root = provable_root(query, time);
    const auto uv = linear::parameters_at(patches, contact->corners, time.lo());
    if (time.is_rational()) {
      truth.witness = Witness{time.lo(), uv};
      if (time.lo() > 0) truth.clearance = LinearClearance{time.lo(), false};
    } else {
      truth.clearance = LinearClearance{time.lo(), true};
    }
    for (size_t s = 0; s < 2; ++s) {
      for (size_t k = 0; k < 2; ++k) out.uv[s][k] = round_down(uv[s][k]);
    }
  }
  conclude(query, truth);
  return out;
}

}  // namespace ccdfuzz
