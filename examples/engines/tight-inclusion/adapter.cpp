// Tight-Inclusion: its vertex-face and edge-edge tests, which are conservative. A query is given to
// it exactly, or refused. Options: tolerance=1e-6 (in space), max-iterations=1000000 (-1: no
// limit), any-numbers=1 (else floats near 1). With all=1 it is asked about grazes, degenerate
// features and contacts at an end of the step, too, but about no separation. It promises to report
// what comes nearer, and not what comes as near.
#include <tight_inclusion/ccd.hpp>

#include "../../plugins/adapter.hpp"

namespace ccd = adapter::ccd;

struct TightInclusion {
  explicit TightInclusion(const std::string& text) : options(text) {
    tolerance = options.number("tolerance", 1e-6);
    max_iterations = static_cast<long>(options.number("max-iterations", 1e6));
    any_numbers = options.number("any-numbers", 0) != 0;
    all = options.number("all", 0) != 0;
    options.check_all_known();
  }

  ccd::Description describe() const {
    ccd::Description d{"Tight-Inclusion", ENGINE_VERSION};
    d.claims |= CCDFUZZ_CONSERVATIVE | CCDFUZZ_TAKES_ENDS;  // both ends of the step are in it
    if (!all) d.claims |= CCDFUZZ_ORDINARY | CCDFUZZ_TAKES_SEPARATION;
    if (!any_numbers) d.claims |= CCDFUZZ_BINARY32;
    if (!any_numbers) d.within = 7;  // then a float and a float times 2^n have a double as sum
    d.pairs = ccd::linear_pairs();
    d.tolerance_kind = CCDFUZZ_TOLERANCE_SPACE;
    d.tolerance = tolerance;
    d.promise =
#include "promise.json"
        ;
    return d;
  }

  ccd::Answer answer(const ccd::Query& query) const {
    const adapter::ExactEnds<ticcd::Vector3> ends(query);
    const auto& p = ends.points;
    const ticcd::Array3 no_scene = ticcd::Array3::Constant(-1);
    double toi = 0, achieved = 0;
    const auto test = query.raw.patches[0]->shape == CCDFUZZ_POINT ? kVertexFace : kEdgeEdge;
    const bool hit =
        test(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], no_scene, query.raw.separation, toi,
             tolerance, query.t_max() / ends.step, max_iterations, achieved, false,
             ticcd::CCDRootFindingMethod::BREADTH_FIRST_SEARCH);
    if (!hit) return ccd::Answer::miss();
    ccd::Answer answer = ccd::Answer::hit(ends.step * toi);
    // It may stop early, with a larger tolerance; what it then says of a hit is still conservative.
    if (achieved <= tolerance) answer.tolerance = achieved;
    return answer;
  }

  static constexpr auto kVertexFace =
      static_cast<decltype(&ticcd::edgeEdgeCCD)>(&ticcd::vertexFaceCCD);
  static constexpr auto kEdgeEdge = &ticcd::edgeEdgeCCD;
  adapter::Options options;
  bool any_numbers = false, all = false;
  double tolerance = 1e-6;
  long max_iterations = 1000000;
};

CCDFUZZ_PLUGIN(TightInclusion)
