#include "method/plugin/probes.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace ccdfuzz {

namespace {

/// A number that depends on every bit of a query.
std::uint64_t mixed_bits(const Query& query) {
  std::uint64_t mix = std::bit_cast<std::uint64_t>(query.t_max);
  for (const MovingPatch<double>& patch : query.patches) {
    const auto mix_in = [&](double x) {
      mix = (mix ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15;  // 2^64 / phi, odd
      mix ^= mix >> 32;
    };
    for_each_coordinate(patch, mix_in);
    for (const double w : patch.weights) mix_in(w);
    for_each_vertex(patch, mix_in);
  }
  return mix;
}

}  // namespace

Query decoy_query(const Query& query) {
  Query other = query;
  for (size_t side = 0; side < 2; ++side) {
    MovingPatch<double>& patch = other.patches[side];
    if (is_of_bodies(query)) {  // bodies stay such that engines can make them
      patch.velocities[0] = -patch.velocities[0];
      continue;
    }
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      patch.positions[i] = {8.0 * static_cast<double>(side), static_cast<double>(i % 2),
                            static_cast<double>(i % 3)};
    }
    patch.moves() = patch.has_ends()
                        ? patch.positions
                        : Points<double>(patch.velocities.size(), Vec3<double>(0, 0, 0));
  }
  other.t_max = 1;
  return other;
}

PoisonedQuery poisoned_query(const Query& query) {
  std::uint64_t mix = mixed_bits(query);
  const auto take = [&mix](size_t choices) {
    const auto taken = static_cast<size_t>(mix % choices);
    mix /= choices;
    return taken;
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr std::array kPoisons = {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity};
  PoisonedQuery out{query, ""};
  const size_t side = take(2);
  const bool in_moves = take(2) == 1;
  MovingPatch<double>& patch = out.query.patches[side];
  Points<double>& moves = patch.moves();
  Points<double>& poisoned = in_moves ? moves : patch.positions;
  const size_t point = take(poisoned.size());
  const size_t k = take(3);
  const double poison = kPoisons[take(kPoisons.size())];
  poisoned[point][static_cast<int>(k)] = poison;
  const char* const name = !in_moves ? "positions" : patch.has_ends() ? "ends" : "velocities";
  out.where = fmt::format("patches[{}].{}[{}][{}] = {}", side, name, point, k, poison);
  return out;
}

}  // namespace ccdfuzz
