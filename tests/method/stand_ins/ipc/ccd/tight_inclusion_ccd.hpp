// A stand-in for ipc-toolkit: the signatures of its narrow phase that the adapter uses, as of
// version 1.4 (commit 12a6475 of its repository). Before, each ConstRef was
// Eigen::ConstRef<Eigen::Vector3d>. Nothing is defined.
#pragma once

#include <Eigen/Core>

namespace Eigen {
template <typename T>
using ConstRef = const Ref<const T>&;
}  // namespace Eigen

namespace ipc {

class NarrowPhaseCCD {
 public:
  NarrowPhaseCCD() = default;
  virtual ~NarrowPhaseCCD() = default;

  virtual bool point_triangle_ccd(
      Eigen::ConstRef<Eigen::Vector3d> p_t0, Eigen::ConstRef<Eigen::Vector3d> t0_t0,
      Eigen::ConstRef<Eigen::Vector3d> t1_t0, Eigen::ConstRef<Eigen::Vector3d> t2_t0,
      Eigen::ConstRef<Eigen::Vector3d> p_t1, Eigen::ConstRef<Eigen::Vector3d> t0_t1,
      Eigen::ConstRef<Eigen::Vector3d> t1_t1, Eigen::ConstRef<Eigen::Vector3d> t2_t1, double& toi,
      const double min_distance = 0.0, const double tmax = 1.0) const = 0;

  virtual bool edge_edge_ccd(
      Eigen::ConstRef<Eigen::Vector3d> ea0_t0, Eigen::ConstRef<Eigen::Vector3d> ea1_t0,
      Eigen::ConstRef<Eigen::Vector3d> eb0_t0, Eigen::ConstRef<Eigen::Vector3d> eb1_t0,
      Eigen::ConstRef<Eigen::Vector3d> ea0_t1, Eigen::ConstRef<Eigen::Vector3d> ea1_t1,
      Eigen::ConstRef<Eigen::Vector3d> eb0_t1, Eigen::ConstRef<Eigen::Vector3d> eb1_t1, double& toi,
      const double min_distance = 0.0, const double tmax = 1.0) const = 0;
};

class TightInclusionCCD : public NarrowPhaseCCD {
 public:
  TightInclusionCCD(const double tolerance = 1e-6, const long max_iterations = 10'000'000L,
                    const double conservative_rescaling = 0.8);

  bool point_triangle_ccd(
      Eigen::ConstRef<Eigen::Vector3d> p_t0, Eigen::ConstRef<Eigen::Vector3d> t0_t0,
      Eigen::ConstRef<Eigen::Vector3d> t1_t0, Eigen::ConstRef<Eigen::Vector3d> t2_t0,
      Eigen::ConstRef<Eigen::Vector3d> p_t1, Eigen::ConstRef<Eigen::Vector3d> t0_t1,
      Eigen::ConstRef<Eigen::Vector3d> t1_t1, Eigen::ConstRef<Eigen::Vector3d> t2_t1, double& toi,
      const double min_distance = 0.0, const double tmax = 1.0) const override;

  bool edge_edge_ccd(
      Eigen::ConstRef<Eigen::Vector3d> ea0_t0, Eigen::ConstRef<Eigen::Vector3d> ea1_t0,
      Eigen::ConstRef<Eigen::Vector3d> eb0_t0, Eigen::ConstRef<Eigen::Vector3d> eb1_t0,
      Eigen::ConstRef<Eigen::Vector3d> ea0_t1, Eigen::ConstRef<Eigen::Vector3d> ea1_t1,
      Eigen::ConstRef<Eigen::Vector3d> eb0_t1, Eigen::ConstRef<Eigen::Vector3d> eb1_t1, double& toi,
      const double min_distance = 0.0, const double tmax = 1.0) const override;
};

}  // namespace ipc
