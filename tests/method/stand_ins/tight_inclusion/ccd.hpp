// A stand-in for Tight-Inclusion: the signatures that it publishes (commit 029ca74 of its
// repository, built for doubles), so that its adapter is compiled where the library is not there.
// Nothing is defined.
#pragma once

#include <Eigen/Core>

namespace ticcd {

using Scalar = double;
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
using Array3 = Eigen::Array<Scalar, 3, 1>;

enum class CCDRootFindingMethod { DEPTH_FIRST_SEARCH, BREADTH_FIRST_SEARCH };

bool edgeEdgeCCD(
    const Vector3& ea0_t0, const Vector3& ea1_t0, const Vector3& eb0_t0, const Vector3& eb1_t0,
    const Vector3& ea0_t1, const Vector3& ea1_t1, const Vector3& eb0_t1, const Vector3& eb1_t1,
    const Array3& err, const Scalar ms, Scalar& toi, const Scalar tolerance, const Scalar t_max,
    const long max_itr, Scalar& output_tolerance, bool no_zero_toi = false,
    const CCDRootFindingMethod ccd_method = CCDRootFindingMethod::BREADTH_FIRST_SEARCH);

bool vertexFaceCCD(
    const Vector3& v_t0, const Vector3& f0_t0, const Vector3& f1_t0, const Vector3& f2_t0,
    const Vector3& v_t1, const Vector3& f0_t1, const Vector3& f1_t1, const Vector3& f2_t1,
    const Array3& err, const Scalar ms, Scalar& toi, const Scalar tolerance, const Scalar t_max,
    const long max_itr, Scalar& output_tolerance, bool no_zero_toi = false,
    const CCDRootFindingMethod ccd_method = CCDRootFindingMethod::BREADTH_FIRST_SEARCH);

}  // namespace ticcd
