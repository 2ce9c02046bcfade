#pragma once

namespace ccdfuzz {

/// What a method answers beyond patches with velocities.
struct Features {
  /// Ends, also those whose difference to the positions is no double.
  bool ends = false;
  /// A separation above 0.
  bool separation = false;
  /// Weights that are not all equal.
  bool weights = false;
  /// Two convex bodies (ShapeKind::kHull).
  bool bodies = false;
  /// Bodies that turn by quaternions, by cosine and sine, and by an angular velocity.
  bool turns = false, angles = false, spins = false;
  /// A body against a mesh, and against one that is one-sided.
  bool meshes = false, one_sided = false;
  /// Patches with a trim.
  bool trims = false;
  /// Patches that come nearer than this count for it as touching. So it takes separations below
  /// this, of which it is not told. ≥ 0, finite; 0 where it takes all separations.
  double kept_separation = 0;
};

/// Whether it takes bodies against meshes, and no two that are convex.
constexpr bool takes_meshes_alone(const Features& features) {
  return !features.bodies && (features.meshes || features.one_sided);
}

/// Whether it takes any queries of bodies.
constexpr bool takes_bodies(const Features& features) {
  return features.bodies || takes_meshes_alone(features);
}

/// Whether a method knows a separation by its claim to keep patches apart, and is not told.
constexpr bool is_kept(double separation, const Features& features) {
  return separation > 0 && separation < features.kept_separation;
}

}  // namespace ccdfuzz
