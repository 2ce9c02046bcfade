#include "ccd/past_start.hpp"

#include <algorithm>

#include "bezier/exact_patch.hpp"
#include "ccd/nearest_points.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// The largest double ≤ √x, but for 2^-64 of it. Requires x ≥ 0.
double root_below(const Rational& x) {
  constexpr unsigned kBits = 64;
  const Integer root = sqrt(Integer(x.get_num() * x.get_den() << 2 * kBits));
  Rational below(root, Integer(x.get_den() << kBits));
  below.canonicalize();
  return round_down(below);
}

}  // namespace

Answer past_start(const Query& query, Answer answer) {
  if (answer.verdict != Verdict::kHit || answer.toi != 0 || is_of_bodies(query)) return answer;
  const std::array<MovingPatch<Rational>, 2> patches = {exact_patch<Rational>(query.patches[0]),
                                                        exact_patch<Rational>(query.patches[1])};
  const Rational apart = NearestPoints()(patches[0].positions, patches[1].positions).squared;
  const Rational d = exact(query.separation);
  const Rational more = apart - d * d;
  if (more <= 0) return answer;
  Rational fastest = 0;
  for (const Vec3<Rational>& v : patches[0].velocities) {
    for (const Vec3<Rational>& w : patches[1].velocities) {
      const Vec3<Rational> against = w - v;
      fastest = std::max(fastest, Rational(dot(against, against)));
    }
  }
  const bool moves = fastest > 0;
  if (moves) answer.toi = root_below(more * more / (4 * apart * fastest));
  if (moves && *answer.toi <= query.t_max) return answer;
  Answer miss = Answer::miss();
  static_cast<Cost&>(miss) = answer;
  miss.work = answer.work;
  return miss;
}

}  // namespace ccdfuzz
