// FCL (Debian libfcl-dev): the vertex-face and edge-edge tests of its deforming meshes, which
// look for the roots of a cubic in [0, 1].
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include "../../plugins/adapter.hpp"

struct Fcl {
  explicit Fcl(const std::string& text) : options(text) { options.check_all_known(); }

  static adapter::ccd::Description describe() {
    adapter::ccd::Description description{"FCL", ENGINE_VERSION};
    description.claims = CCDFUZZ_ORDINARY;  // neither a contact at 0 nor one at the end
    description.within = 14;
    description.promise =
#include "promise.json"
        ;
    description.pairs = adapter::ccd::linear_pairs();
    // It gives the middle of an interval of this width (getCcdResolution).
    description.tolerance_kind = CCDFUZZ_TOLERANCE_TIME_RELATIVE;
    description.tolerance = 1e-7;
    return description;
  }

  static adapter::ccd::Answer answer(const adapter::ccd::Query& query) {
    using Vector = fcl::Vector3<double>;
    using Test = fcl::detail::Intersect<double>;
    const auto p = adapter::end_points<Vector>(query);
    double toi = 0;
    Vector where;
    const bool touches =
        query.raw.patches[0]->shape == CCDFUZZ_POINT
            ? Test::intersect_VF(p[1], p[2], p[3], p[0], p[5], p[6], p[7], p[4], &toi, &where)
            : Test::intersect_EE(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], &toi, &where);
    return touches ? adapter::ccd::Answer::hit(adapter::scaled_toi(toi, query.t_max()))
                   : adapter::ccd::Answer::miss();
  }

  adapter::Options options;
};

CCDFUZZ_PLUGIN(Fcl)
