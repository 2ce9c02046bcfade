// Box2D v3: b2TimeOfImpact.
#include <box2d/collision.h>

#include "../sweeps.hpp"

struct Box2d {
  using Input = b2TOIInput;
  static constexpr std::uint32_t kClaims = CCDFUZZ_PLANE, kTurns = CCDFUZZ_TAKES_ANGLES;
  static constexpr auto kFailed = b2_toiStateFailed, kSeparated = b2_toiStateSeparated;
  static constexpr b2Rot kNoRotation = {1, 0};
  static constexpr auto time_of_impact = b2TimeOfImpact;

  static adapter::ccd::Description describe() {
    adapter::ccd::Description d{"Box2D"};
    d.pairs = {{{CCDFUZZ_HULL, CCDFUZZ_HULL}, {B2_MAX_POLYGON_VERTICES, B2_MAX_POLYGON_VERTICES}}};
    d.bodies = {{1, B2_MAX_POLYGON_VERTICES, CCDFUZZ_ANY_RADIUS}};
    d.promise =
#include "promise.json"
        ;
    return d;
  }

  static b2Vec2 vector(const double (&x)[3]) {
    return {adapter::as_float(x[0]), adapter::as_float(x[1])};
  }

  static b2Rot rotation(const double* q) {
    return {adapter::of_unit(q, 2, 0), adapter::of_unit(q, 2, 1)};
  }

  static b2ShapeProxy proxy(const std::vector<b2Vec2>& points, float radius) {
    return b2MakeProxy(points.data(), static_cast<int>(points.size()), radius);
  }
};

CCDFUZZ_PLUGIN(adapter::Sweeps<Box2d>)
