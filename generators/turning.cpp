#include "generators/turning.hpp"

#include <cmath>

#include "base/verify.hpp"
#include "case/scale.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/bodies.hpp"

namespace ccdfuzz {

namespace {

/// A turn that is the identity at `t`, and whose two ends have lengths of about 1.
BodyTurn turn_about(const Vec3<double>& centre, double t, bool in_plane, Draw& draw) {
  constexpr int kEighths = 8;
  const Vec3<double> d = draw.until(
      [&] {
        const auto part = [&] {
          return static_cast<double>(draw.integer(1 - kEighths, kEighths - 1)) / kEighths;
        };
        const double z = part();
        if (in_plane) return Vec3<double>(0, 0, z);
        const double x = part();
        return Vec3<double>(x, part(), z);
      },
      // Then from·to > 0.
      [](const Vec3<double>& v) { return v.squaredNorm() > 0 && v.squaredNorm() < 0.8; });
  const double slower = draw.coin() ? 1 : 0.5;
  BodyTurn turn{{}, {}, centre};
  for (const auto& [numbers, share] : {std::pair(&turn.from, -t), std::pair(&turn.to, 1 - t)}) {
    const Vec3<double> part = slower * share * d;
    const auto rest = static_cast<double>(static_cast<float>(std::sqrt(1 - part.squaredNorm())));
    *numbers = in_plane ? std::vector{rest, part[2]} : std::vector{rest, part[0], part[1], part[2]};
  }
  return turn;
}

/// A place in or near a body.
Vec3<double> draw_centre(const Points<double>& points, bool in_plane, Draw& draw) {
  Vec3<double> centre = points[draw.below(points.size())];
  if (points.size() > 1) return (centre + points[draw.below(points.size())]) / 2;
  for (int k = 0; k < (in_plane ? 2 : 3); ++k) {
    centre[k] += static_cast<double>(draw.integer(-2, 2));
  }
  return centre;
}

}  // namespace

tl::expected<Case, Discard> turning_case(const GeneratorOptions& options, const Dyadic& eps_t,
                                         Draw& draw) {
  GeneratorOptions plain = options;
  plain.kind = CaseKind::kRP;
  tl::expected<Case, Discard> made = bodies_case(plain, eps_t, draw);
  if (!made) return made;
  Case& out = *made;
  Query& query = out.query;
  Witness witness = *out.truth.witness;
  if (witness.t == 1) {  // twice as fast
    witness.t /= 2;
    for (MovingPatch<double>& body : query.patches) body.velocities[0] *= 2;
  }
  const double t = round_down(witness.t);
  query.t_max = draw.coin() ? 1 : (1 + t) / 2;
  const std::uint64_t which = draw.below(3);  // the first, the second or both
  for (size_t s = 0; s < 2; ++s) {
    if (which == 1 - s) continue;
    const Vec3<double> centre = draw_centre(query.patches[s].positions, options.plane, draw);
    query.patches[s].turn = turn_about(centre, t, options.plane, draw);
  }
  if (!is_binary32(query)) return tl::unexpected(Discard::kRoundTrip);
  OracleOptions limits;
  limits.known = witness;
  out.truth = decide(query, limits).truth;
  const auto& found = out.truth.witness;
  const bool is_first = found && found->t == witness.t && out.truth.clear_until &&
                        witness.t - *out.truth.clear_until <= eps_t.rational();
  if (!is_first) return tl::unexpected(Discard::kFirstContact);
  if (options.kind == CaseKind::kRP) return made;
  query.t_max = t - *eps_t.to_double_exactly();
  out.truth.collides = false;
  out.truth.witness.reset();
  out.truth.proof = proof_word(*out.truth.clearance);
  CCDFUZZ_VERIFY(covers(*out.truth.clearance, exact(query.t_max)));
  return made;
}

}  // namespace ccdfuzz
