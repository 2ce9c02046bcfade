// ipc-toolkit: its additive CCD. A query is given to it exactly, or refused. Options: rescaling=0.9
// (conservative_rescaling), max-iterations=-1 (no limit), any-numbers=1 (else floats near 1). With
// all=1 it is asked about grazes, degenerate features and contacts at the end of the step, too.
#include <ipc/ccd/additive_ccd.hpp>
#include <ipc/utils/logger.hpp>

#include "../../plugins/adapter.hpp"

namespace ccd = adapter::ccd;

struct IpcToolkit {
  explicit IpcToolkit(const std::string& text) : options(text) {
    method.conservative_rescaling = options.number("rescaling", method.conservative_rescaling);
    method.max_iterations = static_cast<long>(options.number("max-iterations", -1));
    any_numbers = options.number("any-numbers", 0) != 0;
    all = options.number("all", 0) != 0;
    options.check_all_known();
    ipc::logger().set_level(spdlog::level::off);  // it warns on stdout
  }

  ccd::Description describe() const {
    ccd::Description d{"ipc-toolkit, AdditiveCCD", ENGINE_VERSION};
    d.claims |= CCDFUZZ_TAKES_ENDS | CCDFUZZ_TAKES_SEPARATION;
    if (!all) d.claims |= CCDFUZZ_ORDINARY;
    if (all) d.claims &= ~CCDFUZZ_CONTACT_AT_ZERO;  // of that distance it may see a rounded one
    if (!any_numbers) d.claims |= CCDFUZZ_BINARY32;
    if (!any_numbers) d.within = 7;  // then a float and a float times 2^n have a double as sum
    d.pairs = ccd::linear_pairs();
    d.pairs.push_back({{CCDFUZZ_POINT, CCDFUZZ_CURVE}, {0, 1}});
    d.pairs.push_back({{CCDFUZZ_POINT, CCDFUZZ_POINT}, {0, 0}});
    // It stops at a share of the first distance, which is at most 2 √3 times the largest
    // coordinate.
    d.tolerance_kind = CCDFUZZ_TOLERANCE_SPACE_RELATIVE;
    d.tolerance = std::min(1., 3.5 * (1 - method.conservative_rescaling));
    d.promise =
#include "promise.json"
        ;
    return d;
  }

  ccd::Answer answer(const ccd::Query& query) const {
    const adapter::ExactEnds<Eigen::Vector3d> ends(query);
    double toi = 0;
    const bool hit = test(query, ends.points, toi, query.t_max() / ends.step);
    return hit ? ccd::Answer::hit(ends.step * toi) : ccd::Answer::miss();
  }

  bool test(const ccd::Query& query, const std::array<Eigen::Vector3d, 8>& p, double& toi,
            double t_max) const {
    const double apart = query.raw.separation;
    const ccdfuzz_patch& first = *query.raw.patches[0];
    if (first.shape == CCDFUZZ_CURVE) {
      return method.edge_edge_ccd(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], toi, apart,
                                  t_max);
    }
    switch (query.raw.patches[1]->shape) {
      case CCDFUZZ_POINT:
        return method.point_point_ccd(p[0], p[1], p[4], p[5], toi, apart, t_max);
      case CCDFUZZ_CURVE:
        return method.point_edge_ccd(p[0], p[1], p[2], p[4], p[5], p[6], toi, apart, t_max);
      default:
        return method.point_triangle_ccd(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], toi, apart,
                                         t_max);
    }
  }

  adapter::Options options;
  bool any_numbers = false, all = false;
  ipc::AdditiveCCD method;
};

CCDFUZZ_PLUGIN(IpcToolkit)
