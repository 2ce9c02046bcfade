#include "fuzz/mutator/witnessed_query.hpp"

#include <algorithm>

#include "bezier/bernstein.hpp"
#include "fuzz/mutator/small_dyadic.hpp"
#include "generators/exact_sum.hpp"
#include "generators/shaped/features.hpp"

namespace ccdfuzz {

namespace {

bool is_zero(const Dyadic& x) {
  return x.sign() == 0;
}
bool is_zero(const SmallDyadic& x) {
  return x.is_zero();
}
bool is_zero(const Vec3<Dyadic>& v) {
  return v[0].sign() == 0 && v[1].sign() == 0 && v[2].sign() == 0;
}

Vec3<Dyadic> scaled(const Vec3<Dyadic>& v, long shift) {
  return {v[0].scaled(shift), v[1].scaled(shift), v[2].scaled(shift)};
}

/// k where x = 2^k.
std::optional<long> exponent_of_power_of_two(const Dyadic& x) {
  if (x.mantissa() != 1) return std::nullopt;
  return x.exponent();
}

bool shift_all(Points<double>& points, const Vec3<Dyadic>& by) {
  for (Vec3<double>& p : points) {
    if (!add_exactly(p, by)) return false;
  }
  return true;
}

bool all_fit(const std::vector<SmallDyadic>& all) {
  return std::all_of(all.begin(), all.end(), [](const SmallDyadic& x) { return x.fits(); });
}

std::vector<SmallDyadic> small_weights(const WitnessedQuery& q, size_t side) {
  const Uv<Dyadic>& uv = q.uv[side];
  return bernstein_weights<SmallDyadic>(q.query.patches[side].shape,
                                        {SmallDyadic::of(uv[0]), SmallDyadic::of(uv[1])});
}

/// Σ weight·(position + t·velocity).
template <class S>
std::array<S, 3> weighted_sum(const MovingPatch<double>& patch, const std::vector<S>& weights,
                              const S& t) {
  std::array<S, 3> sum;
  for (size_t i = 0; i < weights.size(); ++i) {
    if (is_zero(weights[i])) continue;
    const S weighted_t = weights[i] * t;
    for (size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double position = patch.positions[i][axis], velocity = patch.velocities[i][axis];
      if (position != 0) sum[k] += weights[i] * S::exact(position);
      if (velocity != 0) sum[k] += weighted_t * S::exact(velocity);
    }
  }
  return sum;
}

/// The ways to move what patch `side` has at the contact by `by`.
bool shift_patch(WitnessedQuery& q, int side, const Vec3<Dyadic>& by) {
  return shift_all(q.query.patches[static_cast<size_t>(side)].positions, by);
}

bool shift_velocity(WitnessedQuery& q, int side, const Vec3<Dyadic>& by) {
  const auto k = exponent_of_power_of_two(q.t);
  return k && shift_all(q.query.patches[static_cast<size_t>(side)].velocities, scaled(by, -*k));
}

bool shift_control(WitnessedQuery& q, int side, const Vec3<Dyadic>& by, Draw& draw) {
  const std::vector<Dyadic> weights = q.weights(side);
  std::vector<size_t> movable;
  for (size_t i = 0; i < weights.size(); ++i) {
    if (exponent_of_power_of_two(weights[i])) movable.push_back(i);
  }
  if (movable.empty()) return false;
  const size_t i = movable[draw.below(movable.size())];
  return add_exactly(q.query.patches[static_cast<size_t>(side)].positions[i],
                     scaled(by, -weights[i].exponent()));
}

}  // namespace

std::vector<Dyadic> WitnessedQuery::weights(int side) const {
  const size_t s = static_cast<size_t>(side);
  const std::vector<SmallDyadic> small = small_weights(*this, s);
  if (!all_fit(small)) return bernstein_weights(query.patches[s].shape, uv[s]);
  std::vector<Dyadic> weights;
  weights.reserve(small.size());
  for (const SmallDyadic& x : small) weights.push_back(x.dyadic());
  return weights;
}

Vec3<Dyadic> WitnessedQuery::contact(int side) const {
  const size_t s = static_cast<size_t>(side);
  const MovingPatch<double>& patch = query.patches[s];
  const auto small = weighted_sum(patch, small_weights(*this, s), SmallDyadic::of(t));
  if (small[0].fits() && small[1].fits() && small[2].fits()) {
    return {small[0].dyadic(), small[1].dyadic(), small[2].dyadic()};
  }
  const auto sum = weighted_sum(patch, bernstein_weights(patch.shape, uv[s]), t);
  return {sum[0], sum[1], sum[2]};
}

std::optional<WitnessedQuery> witnessed_query(const Case& known) {
  const std::optional<Witness>& witness = known.truth.witness;
  if (!witness || witness->t > exact(known.query.t_max)) return std::nullopt;
  const std::optional<Dyadic> t = Dyadic::from(witness->t);
  if (!t) return std::nullopt;
  WitnessedQuery q{known.query, *t, {}};
  for (size_t s = 0; s < 2; ++s) {
    for (size_t k = 0; k < 2; ++k) {
      const std::optional<Dyadic> x = Dyadic::from(witness->uv[s][k]);
      if (!x) return std::nullopt;
      q.uv[s][k] = *x;
    }
  }
  return q;
}

ContactClass contact_class_of(const WitnessedQuery& q) {
  // From the feature of one patch and of the other: the order of the patches is nothing.
  constexpr std::array<std::array<ContactClass, 3>, 3> kClasses = {
      {{ContactClass::kFF, ContactClass::kEF, ContactClass::kVF},
       {ContactClass::kEF, ContactClass::kEE, ContactClass::kVE},
       {ContactClass::kVF, ContactClass::kVE, ContactClass::kVV}}};
  const auto place = [&](size_t side) {
    return static_cast<size_t>(feature_at(q.query.patches[side].shape, q.uv[side]));
  };
  return kClasses[place(0)][place(1)];
}

Witness WitnessedQuery::witness() const {
  Witness w{t.rational(), {}};
  for (size_t s = 0; s < 2; ++s) w.uv[s] = {uv[s][0].rational(), uv[s][1].rational()};
  return w;
}

WitnessedQuery falling_point() {
  WitnessedQuery q;
  q.query.patches[0] = {Shape::point(), {{0, 0, 1}}, {{0, 0, -1}}};
  q.query.patches[1] = {Shape::curve(1), {{-1, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  q.t = Dyadic(1);
  q.uv[1][0] = Dyadic(Integer(1), -1);
  return q;
}

Case case_of(const WitnessedQuery& q) {
  Case out;
  out.origin.contact = name_of(contact_class_of(q));
  out.origin.kind = name_of(CaseKind::kRP);
  out.origin.generator = "mutant";
  out.query = q.query;
  out.truth.collides = true;
  out.truth.witness = q.witness();
  return out;
}

bool add_exactly(double& x, const Dyadic& by) {
  if (const std::optional<double> step = by.to_double_exactly()) {
    double moved = x;
    if (!add_exactly(moved, *step)) return false;
    x = moved;
    return true;
  }
  const std::optional<double> sum = (Dyadic::exact(x) + by).to_double_exactly();
  if (sum) x = *sum;
  return sum.has_value();
}

bool add_exactly(Vec3<double>& x, const Vec3<Dyadic>& by) {
  Vec3<double> sum = x;
  for (int k = 0; k < 3; ++k) {
    if (!add_exactly(sum[k], by[k])) return false;
  }
  x = sum;
  return true;
}

bool repair(WitnessedQuery& q, Draw& draw) {
  const Vec3<Dyadic> apart = q.contact(0) - q.contact(1);
  if (is_zero(apart)) return true;
  constexpr std::uint64_t kWays = 6;
  const std::uint64_t first = draw.below(kWays);
  for (std::uint64_t way = first; way < first + kWays; ++way) {
    WitnessedQuery whole = q;
    const int side = static_cast<int>(way % 2);
    const Vec3<Dyadic> by = side == 0 ? Vec3<Dyadic>(-apart) : apart;
    const std::uint64_t kind = way % kWays / 2;
    if (kind == 0   ? shift_control(whole, side, by, draw)
        : kind == 1 ? shift_patch(whole, side, by)
                    : shift_velocity(whole, side, by)) {
      q = std::move(whole);
      return true;
    }
  }
  return false;
}

}  // namespace ccdfuzz
