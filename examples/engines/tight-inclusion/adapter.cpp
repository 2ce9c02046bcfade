// Tight-Inclusion: its vertex-face and edge-edge tests, which are conservative. A query is given to
// it exactly, or refused. Options: tolerance=1e-6 (in space), max-iterations=1000000 (-1: no
// limit).
#include <tight_inclusion/ccd.hpp>

#include "../../plugins/adapter.hpp"

namespace ccd = adapter::ccd;

struct TightInclusion {
  explicit TightInclusion(const std::string& text) : options(text) {
    tolerance = options.number("tolerance", 1e-6);
    max_iterations = static_cast<long>(options.number("max-iterations", 1e6));
    options.check_all_known();
  }

  ccd::Description describe() const {
    ccd::Description d{"Tight-Inclusion", ENGINE_VERSION};
    d.claims |= CCDFUZZ_CONSERVATIVE | CCDFUZZ_BINARY32 | CCDFUZZ_ORDINARY;
    d.within = 7;  // then a float and a float times a power of two have a double as sum
    d.pairs = ccd::linear_pairs();
    d.tolerance_kind = CCDFUZZ_TOLERANCE_SPACE;
    d.tolerance = tolerance;
    d.promise =
        "conservative: a result of false implies that no collision occurs: "
        "https://github.com/Continuous-Collision-Detection/Tight-Inclusion#details";
    return d;
  }

  /// Its step is as long as the least power of two that holds [0, t_max], and ends at t_max.
  ccd::Answer answer(const ccd::Query& query) const {
    const double step = std::exp2(std::ceil(std::log2(std::max(query.t_max(), 0x1p-60))));
    std::array<ticcd::Vector3, 8> p;
    std::size_t next = 0;
    for (int side = 0; side < 2; ++side) {
      const ccdfuzz_patch& patch = *query.raw.patches[side];
      for (std::uint64_t i = 0; i < patch.count; ++i, ++next) {
        for (int k = 0; k < 3; ++k) {
          const double start = patch.positions[i][k], way = step * patch.velocities[i][k];
          const double end = start + way;
          if (end - start != way || end - way != start) {
            return adapter::refused(adapter::Refusal("an end of the motion is no double"));
          }
          p[next][k] = start;
          p[next + 4][k] = end;
        }
      }
    }
    const ticcd::Array3 no_scene = ticcd::Array3::Constant(-1);
    double toi = 0, achieved = 0;
    const auto test = query.raw.patches[0]->shape == CCDFUZZ_POINT ? kVertexFace : kEdgeEdge;
    const bool hit = test(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], no_scene, 0, toi,
                          tolerance, query.t_max() / step, max_iterations, achieved, false,
                          ticcd::CCDRootFindingMethod::BREADTH_FIRST_SEARCH);
    if (!hit) return ccd::Answer::miss();
    ccd::Answer answer = ccd::Answer::hit(step * toi);
    // It may stop early, with a larger tolerance; what it then says of a hit is still conservative.
    if (achieved <= tolerance) answer.tolerance = achieved;
    return answer;
  }

  static constexpr auto kVertexFace =
      static_cast<decltype(&ticcd::edgeEdgeCCD)>(&ticcd::vertexFaceCCD);
  static constexpr auto kEdgeEdge = &ticcd::edgeEdgeCCD;
  adapter::Options options;
  double tolerance = 1e-6;
  long max_iterations = 1000000;
};

CCDFUZZ_PLUGIN(TightInclusion)
