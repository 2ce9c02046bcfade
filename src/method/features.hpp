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
  /// Bodies (ShapeKind::kHull).
  bool bodies = false;
  /// Bodies that turn by quaternions, by cosine and sine, and by an angular velocity.
  bool turns = false, angles = false, spins = false;
  /// Meshes, and meshes that are one-sided.
  bool meshes = false, one_sided = false;
  /// Patches with a trim.
  bool trims = false;
};

}  // namespace ccdfuzz
