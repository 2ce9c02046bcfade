// FCL (Debian libfcl-dev): continuousCollide of balls and tetrahedra by conservative advancement.
// Some turn, by InterpMotion, whose angular velocity is constant. With overlap=1 some overlap at 0.
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/continuous_collision.h>

#include "../../plugins/adapter.hpp"

namespace ccd = adapter::ccd;
using Vector = fcl::Vector3d;
using Matrix = fcl::Matrix3d;
using Motion = fcl::InterpMotion<double>;

struct FclBodies {
  explicit FclBodies(const std::string& text) {
    adapter::Options options(text);
    overlap = options.number("overlap", 0) != 0;
    options.check_all_known();
  }

  ccd::Description describe() const {
    ccd::Description description{"FCL", ENGINE_VERSION};
    description.claims =
        CCDFUZZ_TAKES_BODIES | CCDFUZZ_TAKES_SPINS | CCDFUZZ_ORDINARY;  // open ends
    description.within = 7;
    description.pairs = ccd::body_pairs();
    description.bodies = {{1, 1, CCDFUZZ_POSITIVE_RADIUS}, {4, 4, CCDFUZZ_NO_RADIUS}};
    description.promise =
#include "promise.json"
        ;
    if (overlap) {
      description.claims |= CCDFUZZ_INITIAL_OVERLAP | CCDFUZZ_CONTACT_AT_ZERO;
      description.promise += "; where the start is in collision, the time of contact is 0";
    }
    description.tolerance_kind = CCDFUZZ_TOLERANCE_TIME_RELATIVE;
    description.tolerance = kTimeError;
    return description;
  }

  static std::unique_ptr<fcl::ShapeBased> shape(const ccdfuzz_patch& body) {
    if (body.count == 1) return std::make_unique<fcl::Sphered>(body.radius);
    auto points = std::make_shared<std::vector<Vector>>();
    for (std::uint64_t i = 0; i < body.count; ++i) points->emplace_back(body.positions[i]);
    const auto way = [&](int i) -> Vector { return (*points)[i] - (*points)[0]; };
    if (way(1).cross(way(2)).dot(way(3)) < 0) std::swap((*points)[2], (*points)[3]);
    // Each is seen from outside counterclockwise.
    const auto faces = std::make_shared<std::vector<int>>(
        std::vector<int>{3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3});
    return std::make_unique<fcl::Convexd>(points, 4, faces);
  }

  /// About the spin's centre, which is a point of the body's own frame.
  static Motion motion(const ccdfuzz_patch& body, double t_max) {
    const Vector origin = body.count == 1 ? Vector(body.positions[0]) : Vector(0, 0, 0);
    Vector centre = origin;
    if (body.turn_count > 0) centre = Vector(body.turn_centre);
    const auto [w, x, y, z] = adapter::spun(body, t_max, 3);  // from pi on it turns the other way
    const Matrix turned = fcl::Quaterniond(w, x, y, z).toRotationMatrix();
    const Vector end = centre + t_max * Vector(body.velocities[0]) - turned * (centre - origin);
    return {Matrix::Identity(), origin, turned, end, centre - origin};
  }

  static ccd::Answer answer(const ccd::Query& query) {
    const auto& [a, b] = query.raw.patches;
    const auto first = shape(*a), second = shape(*b);
    const Motion way = motion(*a, query.t_max()), other = motion(*b, query.t_max());
    const fcl::ContinuousCollisionRequestd request(
        10, kTimeError, fcl::CCDM_LINEAR, fcl::GST_LIBCCD, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide(first.get(), &way, second.get(), &other, request, result);
    if (!result.is_collide) return ccd::Answer::miss();
    return ccd::Answer::hit(adapter::scaled_toi(result.time_of_contact, query.t_max()));
  }

  bool overlap = false;
  static constexpr double kTimeError = 1e-4;  // toc_err of a request, by default
};

CCDFUZZ_PLUGIN(FclBodies)
