// Box3D: b3TimeOfImpact.
#include <box3d/collision.h>

#include "../sweeps.hpp"

struct Box3d {
  using Input = b3TOIInput;
  static constexpr std::uint32_t kClaims = 0, kTurns = CCDFUZZ_TAKES_TURNS;
  static constexpr auto kFailed = b3_toiStateFailed, kSeparated = b3_toiStateSeparated;
  static constexpr b3Quat kNoRotation = {{0, 0, 0}, 1};
  static constexpr auto time_of_impact = b3TimeOfImpact;

  static adapter::ccd::Description describe() {
    adapter::ccd::Description d{"Box3D"};
    d.pairs = adapter::ccd::body_pairs();
    d.bodies = {{1, 12, CCDFUZZ_ANY_RADIUS}};  // overlaps of these are measured
    d.promise =
#include "promise.json"
        ;
    return d;
  }

  static b3Vec3 vector(const double (&x)[3]) {
    return {adapter::as_float(x[0]), adapter::as_float(x[1]), adapter::as_float(x[2])};
  }

  static b3Quat rotation(const double* q) {
    return {{adapter::of_unit(q, 4, 1), adapter::of_unit(q, 4, 2), adapter::of_unit(q, 4, 3)},
            adapter::of_unit(q, 4, 0)};
  }

  static b3ShapeProxy proxy(const std::vector<b3Vec3>& points, float radius) {
    return {points.data(), static_cast<int>(points.size()), radius};
  }
};

CCDFUZZ_PLUGIN(adapter::Sweeps<Box3d>)
