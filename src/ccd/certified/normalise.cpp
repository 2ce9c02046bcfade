#include "ccd/certified/normalise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/verify.hpp"

namespace ccdfuzz::certified {

namespace {

constexpr double kEta = std::numeric_limits<double>::denorm_min();

/// The least e with x < 2^e; of 0 far below all others.
int top_of(double x) {
  int e = 0;
  std::frexp(x, &e);
  return x > 0 ? e : std::numeric_limits<int>::min() / 4;
}

/// x·2^exponent as ldexp has it, rounded once where it is subnormal.
class PowerOfTwo {
 public:
  explicit PowerOfTwo(int exponent)
      : exponent_(exponent),
        factor_(-1022 <= exponent && exponent <= 1023 ? std::ldexp(1.0, exponent) : 0) {}
  double times(double x) const { return factor_ != 0 ? x * factor_ : std::ldexp(x, exponent_); }

 private:
  int exponent_;
  double factor_;  ///< 0 where it is no normal number
};

using Controls = std::array<std::vector<std::array<double, 6>>, 2>;

/// Past this exponent p − c could overflow, so all is first scaled down by 2^-2. Ends are
/// subtracted twice, e − c and then − p': for them it is one less, and 2^-3.
constexpr int kLargestSafeExponent = 1022;

/// Subtracts the centre of each component's range, after scaling by 2^-shift. Returns the centres.
/// One rounding each, u·|x − c|: gradual underflow makes a subnormal difference exact.
std::array<double, 3> centre(Controls& controls, int first, int shift) {
  std::array<double, 3> centres{};
  for (int k = first; k < first + 3; ++k) {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    for (auto& side : controls) {
      for (auto& x : side) {
        if (shift != 0) x[k] = std::ldexp(x[k], -shift);
        lo = std::min(lo, x[k]);
        hi = std::max(hi, x[k]);
      }
    }
    const double c = lo / 2 + hi / 2;  // any finite c is right
    for (auto& side : controls) {
      for (auto& x : side) x[k] -= c;
    }
    centres[static_cast<size_t>(k - first)] = c;
  }
  return centres;
}

/// Makes positions p', and velocities or ends v'. c + t·w is common to both patches. Where both
/// have ends, c + w is the centre of the ends; where both have velocities, w is theirs; otherwise w
/// = 0. Where there are ends, both shifts are the same.
void centre_all(Controls& controls, const std::array<bool, 2>& has_ends, int shift_p, int shift_v) {
  const std::array<double, 3> c = centre(controls, 0, shift_p);
  if (has_ends[0] == has_ends[1]) {
    centre(controls, 3, shift_v);
  } else {
    for (size_t s = 0; s < 2; ++s) {
      for (auto& x : controls[s]) {
        for (size_t k = 0; k < 3; ++k) {
          x[k + 3] = std::ldexp(x[k + 3], -shift_v) - (has_ends[s] ? c[k] : 0);
        }
      }
    }
  }
  for (size_t s = 0; s < 2; ++s) {
    if (!has_ends[s]) continue;
    for (auto& x : controls[s]) {
      for (size_t k = 0; k < 3; ++k) x[k + 3] -= x[k];
    }
  }
}

}  // namespace

void normalise(const Query& query, NormalisedQuery& out) {
  for (size_t s = 0; s < 2; ++s) {
    out.weights[s] = scaled_weights(query.patches[s], &out.weight_shift[s]);
  }
  double position = 0, velocity = 0;  // the largest
  std::array<bool, 2> has_ends{};
  for (size_t s = 0; s < 2; ++s) {
    const MovingPatch<double>& patch = query.patches[s];
    has_ends[s] = patch.has_ends() && query.t_max != 0;
    const Points<double>& moves = has_ends[s] ? patch.ends : patch.velocities;
    out.shapes[s] = patch.shape;
    out.controls[s].resize(patch.positions.size());
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        out.controls[s][i][k] = patch.positions[i][k];
        // With t_max = 0 only positions count.
        out.controls[s][i][k + 3] = query.t_max == 0 ? 0.0 : moves[i][k];
        position = std::max(position, std::abs(out.controls[s][i][k]));
        velocity = std::max(velocity, std::abs(out.controls[s][i][k + 3]));
      }
    }
  }
  out.t_max = std::frexp(query.t_max, &out.time);

  // Stage 1 and 2: away from overflow, then to the centre.
  const bool any_ends = has_ends[0] || has_ends[1];
  const int more = any_ends ? 1 : 0;
  const auto shift_of = [more](double largest) {
    return top_of(largest) > kLargestSafeExponent - more ? 2 + more : 0;
  };
  int shift_p = shift_of(position), shift_v = shift_of(velocity);
  if (any_ends) shift_p = shift_v = std::max(shift_p, shift_v);
  centre_all(out.controls, has_ends, shift_p, shift_v);
  // e' and p' have a rounding each and their difference one: 2u·(|p''| + |v''|) where t_max ≤ 1.
  out.roundings = any_ends ? 2 : 0;

  // Stage 3: the larger of positions and of the ways covered in [0, t_max] to magnitude 1.
  double p = 0, v = 0;
  for (const auto& side : out.controls) {
    for (const auto& x : side) {
      for (int k = 0; k < 3; ++k) {
        p = std::max(p, std::abs(x[k]));
        v = std::max(v, std::abs(x[k + 3]));
      }
    }
  }
  const bool is_nothing = p == 0 && v == 0;
  const int top = is_nothing ? 0 : std::max(top_of(p) + shift_p, top_of(v) + shift_v + out.time);
  const int scale_p = shift_p - top, scale_v = shift_v + out.time - top;
  out.space = -top;
  const PowerOfTwo power_p(scale_p), power_v(scale_v);
  std::array<double, 2> largest_p{}, largest_v{};
  for (size_t s = 0; s < 2; ++s) {
    for (auto& x : out.controls[s]) {
      for (int k = 0; k < 3; ++k) {
        x[k] = power_p.times(x[k]);
        x[k + 3] = power_v.times(x[k + 3]);
        largest_p[s] = std::max(largest_p[s], std::abs(x[k]));
        largest_v[s] = std::max(largest_v[s], std::abs(x[k + 3]));
      }
    }
  }
  out.magnitude = (largest_p[0] + largest_v[0]) + (largest_p[1] + largest_v[1]);
  out.separation = std::ldexp(query.separation, out.space);
  if (std::ldexp(out.separation, -out.space) < query.separation) {
    out.separation = std::nextafter(out.separation, std::numeric_limits<double>::infinity());
  }
  // Whatever is beyond 4·√3 holds all points of the scene; an infinity would make 0·∞ of no axis.
  out.separation = std::min(out.separation, std::numeric_limits<double>::max());
  // ldexp rounds only into the subnormal range: ≤ η/2 in stage 3. Stage 1 loses at most η/2 in x
  // and η/2 in c, and stage 3 multiplies both by 2^scale. With ends it loses it in e and p.
  out.absolute = kLeastAbsolute;  // ≥ η
  if (shift_p != 0) out.absolute += std::ldexp(kEta, std::max(scale_p, 0));
  if (shift_v != 0) out.absolute += std::ldexp(kEta, std::max(scale_v, 0) + more);
  CCDFUZZ_ASSERT(out.t_max == 0 || (0.5 <= out.t_max && out.t_max < 1));
  CCDFUZZ_ASSERT(out.absolute >= kLeastAbsolute);
  for (size_t s = 0; s < 2; ++s) CCDFUZZ_ASSERT(largest_p[s] <= 1 && largest_v[s] <= 1);
}

double original_time(double t, int time) {
  const double scaled = std::ldexp(t, time);
  return std::ldexp(scaled, -time) > t ? std::nextafter(scaled, 0.0) : scaled;
}

}  // namespace ccdfuzz::certified
