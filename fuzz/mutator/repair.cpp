#include "fuzz/mutator/repair.hpp"

namespace ccdfuzz {

namespace {

/// k where x = 2^k.
std::optional<long> exponent_of_power_of_two(const Dyadic& x) {
  if (x.mantissa() != 1) return std::nullopt;
  return x.exponent();
}

/// The ways to move what patch `side` has at the contact by `by` over its weight there.
bool shift_patch(Contact& q, size_t side, const Vec3<Dyadic>& by) {
  MovingPatch<double>& patch = q.query.patches[side];
  const auto way = divided(by, q.weight(side));
  return way && add_exactly(patch.positions, *way) &&
         (!patch.has_ends() || add_exactly(patch.ends, *way));
}

bool shift_velocity(Contact& q, size_t side, const Vec3<Dyadic>& by) {
  const auto k = exponent_of_power_of_two(q.t);
  const auto way = divided(by, q.weight(side));
  return k && way && add_exactly(q.query.patches[side].moves(), *way * Dyadic(1, -*k));
}

bool shift_control(Contact& q, size_t side, const Vec3<Dyadic>& by, Draw& draw) {
  const std::vector<Dyadic> weights = q.weights(side);
  std::vector<size_t> movable;
  for (size_t i = 0; i < weights.size(); ++i) {
    if (exponent_of_power_of_two(weights[i])) movable.push_back(i);
  }
  if (movable.empty()) return false;
  const size_t i = movable[draw.below(movable.size())];
  MovingPatch<double>& patch = q.query.patches[side];
  const Vec3<Dyadic> shift = by * Dyadic(1, -weights[i].exponent());
  return add_exactly(patch.positions[i], shift) &&
         (!patch.has_ends() || add_exactly(patch.ends[i], shift));
}

}  // namespace

bool repair(Contact& q, Draw& draw) {
  if (!is_in_trims(q)) return false;
  const Vec3<Dyadic> apart = q.offset();
  if (apart == Vec3<Dyadic>()) return true;
  constexpr std::uint64_t kWays = 6;
  const std::uint64_t first = draw.below(kWays);
  for (std::uint64_t way = first; way < first + kWays; ++way) {
    Contact whole = q;
    const size_t side = way % 2;
    // Over the weight of the other patch: what the numerator of this one is short of.
    const auto short_of = divided(side == 0 ? Vec3<Dyadic>(-apart) : apart, q.weight(1 - side));
    if (!short_of) continue;
    const Vec3<Dyadic>& by = *short_of;
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
