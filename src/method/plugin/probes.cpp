#include "method/plugin/probes.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "case/scale.hpp"
#include "method/setting.hpp"

namespace ccdfuzz {

namespace {

/// A number that depends on every bit of a query's patches and of t_max.
std::uint64_t mixed_bits(const Query& query) {
  auto mix = std::bit_cast<std::uint64_t>(query.t_max);
  for (const MovingPatch<double>& patch : query.patches) {
    for_each_number(patch, [&](double x) {
      mix = (mix ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15;  // 2^64 / phi, odd
      mix ^= mix >> 32;
    });
  }
  return mix;
}

/// A number of a patch, and where it is.
struct Number {
  std::string path;
  double* at;
};
using Numbers = std::vector<Number>;

Numbers listed(const std::string& path, auto& numbers) {
  Numbers out;
  for (double& x : numbers) out.push_back({fmt::format("{}[{}]", path, out.size()), &x});
  return out;
}

/// The numbers of a patch that a NaN may be among, each list of its own field.
std::vector<Numbers> numbers_of(MovingPatch<double>& patch) {
  const auto of_points = [](const char* field, Points<double>& points) {
    Numbers out;
    for (size_t i = 0; i < points.size(); ++i) {
      for (Number& x : listed(fmt::format("{}[{}]", field, i), points[i])) out.push_back(x);
    }
    return out;
  };
  std::vector all = {of_points("positions", patch.positions),
                     of_points(patch.has_ends() ? "ends" : "velocities", patch.moves())};
  if (patch.shape.kind != ShapeKind::kHull) return all;
  if (patch.faces.empty()) all.push_back({{"radius", &patch.radius}});
  if (!patch.turn) return all;
  BodyTurn& turn = *patch.turn;
  for (const auto& [path, numbers] :
       {std::pair("spin.velocity", &turn.spin), {"turn.from", &turn.from}, {"turn.to", &turn.to}}) {
    if (!numbers->empty()) all.push_back(listed(path, *numbers));
  }
  return all;
}

}  // namespace

Query decoy_query(const Query& query, const Domain& domain) {
  Query turned = query;
  const auto turn = [](auto& v, size_t from) {
    for (const size_t k : {from, from + 1}) v[k] = 0 - v[k];  // no -0 of a 0
  };
  bool has_speed = true;
  for (MovingPatch<double>& patch : turned.patches) {
    for (Points<double>* points : {&patch.positions, &patch.moves()}) {
      for (Vec3<double>& v : *points) turn(v, 0);
    }
    if (patch.has_ends() || (patch.turn && !patch.turn->is_spin())) has_speed = false;
    if (!patch.turn) continue;
    turn(patch.turn->centre, 0);
    if (patch.turn->is_spin()) turn(patch.turn->spin, 0);
    if (!patch.turn->is_quaternion()) continue;
    turn(patch.turn->from, 1);
    turn(patch.turn->to, 1);
  }
  if (!has_speed) return turned;
  Query faster = turned;
  for (MovingPatch<double>& patch : faster.patches) {
    for (Vec3<double>& v : patch.velocities) v *= 2;
    if (patch.turn) {
      for (double& w : patch.turn->spin) w *= 2;
    }
  }
  faster.t_max /= 2;
  const bool is_promised = is_valid(faster) && is_within_scale(faster, kOrdinaryScale) &&
                           domain.broken_by(faster).empty();
  return is_promised ? faster : turned;
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
  const std::vector<Numbers> all = numbers_of(out.query.patches[side]);
  const Numbers& taken = all[take(all.size())];
  const size_t i = take(taken.size());
  const double poison = kPoisons[take(kPoisons.size())];
  *taken[i].at = poison;
  out.where = fmt::format("patches[{}].{} = {}", side, taken[i].path, poison);
  return out;
}

}  // namespace ccdfuzz
