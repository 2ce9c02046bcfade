// Tight-Inclusion (github.com/Continuous-Collision-Detection/Tight-Inclusion) as a plug-in.
// Options: "tolerance=1e-6" (of the query, in space), "max-iterations=1000000" (-1: no limit).
#include <tight_inclusion/ccd.hpp>

#include "adapter.hpp"

struct TightInclusion {
  explicit TightInclusion(const std::string& text) : options(text) {
    tolerance = options.number("tolerance", 1e-6);
    max_iterations = static_cast<long>(options.number("max-iterations", 1e6));
    options.check_all_known();
  }

  adapter::ccd::Description describe() const {
    adapter::ccd::Description d{"Tight-Inclusion", ""};
    d.claims |= CCDFUZZ_CONSERVATIVE;
    d.pairs = adapter::ccd::linear_pairs();
    d.tolerance_kind = CCDFUZZ_TOLERANCE_SPACE;
    d.tolerance = tolerance;
    return d;
  }

  adapter::ccd::Answer answer(const adapter::ccd::Query& query) const {
    using Vector = ticcd::Vector3;
    const auto p = adapter::end_points<Vector>(query);
    const ticcd::Array3 no_scene = ticcd::Array3::Constant(-1);
    const ticcd::Scalar separation = 0;
    ticcd::Scalar toi = 0, achieved = 0;
    // Motion over [0, t_max] is given as motion over [0, 1].
    const bool hit =
        query.raw.patches[0]->shape == CCDFUZZ_POINT
            ? ticcd::vertexFaceCCD(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], no_scene,
                                   separation, toi, static_cast<ticcd::Scalar>(tolerance), 1,
                                   max_iterations, achieved)
            : ticcd::edgeEdgeCCD(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], no_scene,
                                 separation, toi, static_cast<ticcd::Scalar>(tolerance), 1,
                                 max_iterations, achieved);
    if (!hit) return adapter::ccd::Answer::miss();
    // It gave up early: what it claims would not hold of this hit.
    if (achieved > tolerance) return {};
    auto answer =
        adapter::ccd::Answer::hit(adapter::scaled_toi(static_cast<double>(toi), query.t_max()));
    answer.tolerance = static_cast<double>(achieved);
    return answer;
  }

  adapter::Options options;
  double tolerance = 1e-6;
  long max_iterations = 1000000;
};

CCDFUZZ_PLUGIN(TightInclusion)
