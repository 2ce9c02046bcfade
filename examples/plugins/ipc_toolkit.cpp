// ipc-toolkit (github.com/ipc-sim/ipc-toolkit) as a plug-in, by its narrow-phase interface: here
// with its TightInclusionCCD; any other ipc::NarrowPhaseCCD is one word away.
// Options: "tolerance=1e-6", "max-iterations=10000000", "rescaling=0.8" (of the time of impact),
// "min-distance=0".
#include <ipc/ccd/tight_inclusion_ccd.hpp>

#include <memory>

#include "adapter.hpp"

struct IpcToolkit {
  explicit IpcToolkit(const std::string& text) : options(text) {
    tolerance = options.number("tolerance", 1e-6);
    min_distance = options.number("min-distance", 0);
    narrow_phase = std::make_unique<ipc::TightInclusionCCD>(
        tolerance, static_cast<long>(options.number("max-iterations", 1e7)),
        options.number("rescaling", 0.8));
    options.check_all_known();
  }

  adapter::ccd::Description describe() const {
    adapter::ccd::Description d{"ipc-toolkit, TightInclusionCCD", ""};
    d.claims |= CCDFUZZ_CONSERVATIVE;
    d.pairs = adapter::ccd::linear_pairs();
    d.tolerance_kind = CCDFUZZ_TOLERANCE_SPACE;
    d.tolerance = tolerance;
    d.minimum_separation = min_distance;
    return d;
  }

  adapter::ccd::Answer answer(const adapter::ccd::Query& query) const {
    const auto p = adapter::end_points<Eigen::Vector3d>(query);
    double toi = 0;
    const bool hit = query.raw.patches[0]->shape == CCDFUZZ_POINT
                         ? narrow_phase->point_triangle_ccd(p[0], p[1], p[2], p[3], p[4], p[5],
                                                            p[6], p[7], toi, min_distance, 1)
                         : narrow_phase->edge_edge_ccd(p[0], p[1], p[2], p[3], p[4], p[5], p[6],
                                                       p[7], toi, min_distance, 1);
    if (!hit) return adapter::ccd::Answer::miss();
    return adapter::ccd::Answer::hit(adapter::scaled_toi(toi, query.t_max()));
  }

  adapter::Options options;
  double tolerance = 1e-6;
  double min_distance = 0;
  std::unique_ptr<const ipc::NarrowPhaseCCD> narrow_phase;
};

CCDFUZZ_PLUGIN(IpcToolkit)
