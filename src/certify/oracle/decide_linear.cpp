#include "certify/oracle/decide_linear.hpp"

#include <algorithm>

#include "bezier/bernstein.hpp"
#include "ccd/nearest_points.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/linear/first_contact.hpp"
#include "certify/oracle/is_readable.hpp"

namespace ccdfuzz {

namespace {

constexpr int kMostRounds = 64;

/// Narrows the contact's time until its polynomial proves the contact to the checker. It does in
/// the end: what is not 0 at the root has a sign by its Bernstein coefficients on a short interval.
/// Nothing if the time turns out to be rational, or the numbers get too long before that.
std::optional<ContactRoot> provable_root(const Query& query, linear::RealRoot& time) {
  for (int round = 0; round < kMostRounds && !time.is_rational(); ++round) {
    ContactRoot root{time.polynomial().coefficients(), time.lo(), time.hi()};
    if (!is_readable(root)) break;
    if (check_contact_root(query, root)) return root;
    time.narrow((time.hi() - time.lo()) * power_of_two(-64));
  }
  return std::nullopt;
}

/// The same of a rational time > 0.
std::optional<ContactRoot> provable_root(const Query& query, const Rational& t) {
  for (int round = 1; round < kMostRounds; ++round) {
    const Rational width = t * power_of_two(-64 * round);
    ContactRoot root{{Integer(-t.get_num()), t.get_den()}, t - width, t + width};
    if (!is_readable(root)) break;
    if (check_contact_root(query, root)) return root;
  }
  return std::nullopt;
}

/// Parameters of the patches' nearest points at t.
std::array<Uv<Rational>, 2> nearest_at(const std::array<MovingPatch<Rational>, 2>& patches,
                                       const Rational& t) {
  NearestPoints nearest;
  const auto& weights = nearest(patches[0].at(t), patches[1].at(t)).weights;
  std::array<Uv<Rational>, 2> uv;
  for (size_t s = 0; s < 2; ++s) {
    // Control points 0, 1, 2 of a triangle are its corners w, v, u; of a curve its ends 0 and 1.
    const std::vector<Rational>& w = weights[s];
    uv[s] = {w.size() > 1 ? w.back() : Rational(0), w.size() > 2 ? w[1] : Rational(0)};
    uv[s] = parameters_with_weights(patches[s].shape, patches[s].weights, uv[s]);
  }
  return uv;
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
  std::optional<linear::RealRoot> contact =
      linear::first_contact(patches, until, exact(query.separation));
  if (!contact) {
    truth.clearance = LinearClearance{until, true};
  } else {
    linear::RealRoot& time = *contact;
    time.narrow(until * power_of_two(-64));
    if (t_max > 0 && time.lo() < t_max) time.narrow(t_max * power_of_two(-64));
    // So that t_max is no longer in the enclosure.
    time.sign_of(linear::Polynomial({-t_max.get_num(), t_max.get_den()}));
    const auto at_end = [&] { return Witness{time.hi(), nearest_at(patches, time.hi())}; };
    Witness witness = at_end();
    const auto is_proof = [&] {
      return is_readable(witness) && check_contact(query, witness).has_value();
    };
    // At a separation patches stay in contact, mostly. Then no root is needed.
    bool is_contact = is_proof();
    if (!is_contact && !is_trimmed(query)) {
      truth.contact_root = provable_root(query, time);
      witness = at_end();
      is_contact = is_proof();
      // Parameters may be longer than files may hold, where the time is not.
      if (!is_contact && time.is_rational() && time.lo() > 0) {
        truth.contact_root = provable_root(query, time.lo());
      }
    }
    if (is_contact) truth.witness = witness;
    if (!time.is_rational()) {
      truth.clearance = LinearClearance{time.lo(), true};
    } else if (time.lo() > 0) {
      truth.clearance = LinearClearance{time.lo(), false};
    }
    for (size_t s = 0; s < 2; ++s) {
      for (size_t k = 0; k < 2; ++k) out.uv[s][k] = round_down(witness.uv[s][k]);
    }
  }
  conclude(query, truth);
  return out;
}

}  // namespace ccdfuzz
