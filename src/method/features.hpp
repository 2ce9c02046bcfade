#pragma once

#include <optional>

#include "case/query.hpp"

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

inline constexpr Features kAllFeatures = {.ends = true,
                                          .separation = true,
                                          .weights = true,
                                          .bodies = true,
                                          .turns = true,
                                          .angles = true,
                                          .spins = true,
                                          .meshes = true,
                                          .one_sided = true,
                                          .trims = true};

/// Makes of a query one that a method takes: with velocities, where it does not take ends, and
/// without weights, where it does not take those. Where the query is taken as it is, or is not
/// valid, it is not copied.
class TakenQuery {
 public:
  TakenQuery(const Query& query, const Features& features);

  /// nullptr: not taken, and why() says why.
  const Query* query() const { return query_; }
  const char* why() const { return why_; }

 private:
  std::optional<Query> converted_;
  const Query* query_;
  const char* why_ = "";
};

}  // namespace ccdfuzz
