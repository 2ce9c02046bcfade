// FCL (Debian libfcl-dev): the vertex-face and edge-edge tests of its deforming meshes, which
// look for the roots of a cubic in [0, 1]. With far=1 numbers are up to 2^40, and ends are doubles.
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include "../far.hpp"

struct Fcl {
  explicit Fcl(const std::string& text) {
    adapter::Options options(text);
    far = options.number("far", 0) != 0;
    options.check_all_known();
  }

  adapter::ccd::Description describe() const {
    adapter::ccd::Description description{"FCL", ENGINE_VERSION};
    description.claims = CCDFUZZ_ORDINARY;  // neither a contact at 0 nor one at the end
    description.within = far ? 40 : 14;
    description.promise =
#include "promise.json"
        ;
    description.pairs = adapter::ccd::linear_pairs();
    description.tolerance_kind = CCDFUZZ_TOLERANCE_TIME_RELATIVE;
    description.tolerance = far ? 1 : kResolution;  // far off an answer says its own
    return description;
  }

  using Vector = fcl::Vector3<double>;
  static constexpr double kResolution = 1e-7;  // the width of its last interval, getCcdResolution

  /// The share of the step that rounding may cost: what is ordinary passes this part of its size
  /// deep.
  static constexpr double kThinnest = 0x1p-10;
  static double lost_share(const adapter::ccd::Query& query) {
    double size = 0;
    for (const ccdfuzz_patch* patch : query.raw.patches) {
      for (std::uint64_t i = 1; i < patch->count; ++i) {
        size = std::max(size, (Vector(patch->positions[i]) - Vector(patch->positions[0])).norm());
      }
    }
    return adapter::lost_length(query) / (size * kThinnest);
  }

  adapter::ccd::Answer answer(const adapter::ccd::Query& query) const {
    if (!far) return asked(query, adapter::end_points<Vector>(query), query.t_max());
    const adapter::ExactEnds<Vector> ends(query);
    const double lost = lost_share(query);
    if (lost >= 1) throw adapter::Refusal("features far off are too small");
    adapter::ccd::Answer answer = asked(query, ends.points, ends.step);
    if (answer.toi_lower > query.t_max()) answer = adapter::ccd::Answer::miss();
    answer.tolerance = std::min(1., 2 * kResolution + lost);  // the step is less than two t_max
    return answer;
  }

  static adapter::ccd::Answer asked(const adapter::ccd::Query& query,
                                    const std::array<Vector, 8>& p, double step) {
    using Test = fcl::detail::Intersect<double>;
    double toi = 0;
    Vector where;
    const bool touches =
        query.raw.patches[0]->shape == CCDFUZZ_POINT
            ? Test::intersect_VF(p[1], p[2], p[3], p[0], p[5], p[6], p[7], p[4], &toi, &where)
            : Test::intersect_EE(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], &toi, &where);
    return touches ? adapter::ccd::Answer::hit(adapter::scaled_toi(toi, step))
                   : adapter::ccd::Answer::miss();
  }

  bool far = false;
};

CCDFUZZ_PLUGIN(Fcl)
