#include "ccd/past_start.hpp"

#include <algorithm>

#include "base/fp_guard.hpp"
#include "bezier/exact_patch.hpp"
#include "ccd/nearest_points.hpp"
#include "ccd/nearest_regions.hpp"

namespace ccdfuzz {

namespace {

/// A double ≤ √x, within two ulps of it. Requires x ≥ 0.
double root_below(const Rational& x) {
  constexpr unsigned kBits = 64;
  const Integer root = sqrt(Integer(x.get_num() * x.get_den() << 2 * kBits));
  return round_down(Rational(root) / Integer(x.get_den() << kBits));
}

struct Extent {
  Rational min, max;
};

/// The least and the largest velocity of a patch along an axis.
Extent extent(const MovingPatch<Rational>& patch, int axis) {
  Extent all{patch.velocities[0][axis], patch.velocities[0][axis]};
  for (const Vec3<Rational>& v : patch.velocities) {
    all.min = std::min(all.min, v[axis]);
    all.max = std::max(all.max, v[axis]);
  }
  return all;
}

}  // namespace

Answer past_start(const Query& query, Answer answer) {
  const FpGuard guard;
  if (query.separation == 0 || is_of_bodies(query)) return answer;
  if (answer.verdict != Verdict::kHit || answer.toi != 0) return answer;
  const std::array<MovingPatch<Rational>, 2> patches = {exact_patch<Rational>(query.patches[0]),
                                                        exact_patch<Rational>(query.patches[1])};
  Rational apart = NearestPoints()(patches[0].positions, patches[1].positions).squared;
  const Rational d = exact(query.separation);
  if (apart <= d * d && is_trimmed(query) && are_flat(query)) {
    apart = squared_distance_of_regions(query, d * d);
  }
  const auto more = Rational(apart - d * d);
  if (more <= 0) return answer;
  Rational fastest = 0;
  for (int k = 0; k < 3; ++k) {
    const auto [first, second] = std::array{extent(patches[0], k), extent(patches[1], k)};
    const Rational along(std::max<Rational>(second.max - first.min, first.max - second.min));
    fastest += along * along;
  }
  // The bound and t_max, squared; where nothing moves the divisor is 0.
  const Rational t_max = exact(query.t_max);
  const auto divisor = Rational(4 * apart * fastest);
  if (more * more <= divisor * t_max * t_max) {
    answer.toi = root_below(more * more / divisor);
    return answer;
  }
  Answer miss = Answer::miss();
  static_cast<Cost&>(miss) = answer;
  miss.work = answer.work;
  return miss;
}

}  // namespace ccdfuzz
