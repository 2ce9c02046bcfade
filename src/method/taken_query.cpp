#include "method/taken_query.hpp"

#include <algorithm>

#include "case/mesh.hpp"
#include "case/refusal.hpp"

namespace ccdfuzz {

TakenQuery::TakenQuery(const Query& query, const Features& features) : query_(&query) {
  const auto& [a, b] = query.patches;
  const bool is_untold = is_kept(query.separation, features);
  const bool is_apart = query.separation > 0 && !features.separation && !is_untold;
  const bool is_of_ends = has_ends(query) && !features.ends;
  const bool is_weighted = !(a.weights.empty() && b.weights.empty()) && !features.weights;
  const bool has_bodies = is_of_bodies(query) && !has_mesh(query) && !features.bodies;
  const bool has_turning = std::ranges::any_of(query.patches, [&](const MovingPatch<double>& body) {
    return body.turn && !(body.turn->is_quaternion() ? features.turns
                          : body.turn->is_spin()     ? features.spins
                                                     : features.angles);
  });
  const bool has_meshes = std::ranges::any_of(query.patches, [&](const MovingPatch<double>& body) {
    return !body.faces.empty() && !(body.one_sided ? features.one_sided : features.meshes);
  });
  const bool has_trims = is_trimmed(query) && !features.trims;
  const bool is_taken = !is_apart && !is_untold && !is_of_ends && !is_weighted && !has_bodies &&
                        !has_turning && !has_meshes && !has_trims;
  if (is_taken || !is_valid(query)) return;
  why_ = has_trims     ? "takes whole patches, and one of this query is trimmed"
         : has_meshes  ? (features.meshes      ? "takes no one-sided meshes"
                          : features.one_sided ? "takes one-sided meshes alone"
                                               : "takes no meshes")
         : has_turning ? "takes no bodies that turn so"
         : has_bodies
             ? (takes_meshes_alone(features) ? "takes meshes, and this query has none" : kNoBodies)
         : is_apart ? "knows touching alone, and this query has a separation"
                    : "";
  if (*why_ != '\0') query_ = nullptr;
  const auto use = [this](std::optional<Query> made, const char* why_not) {
    converted_ = std::move(made);
    query_ = converted_ ? &*converted_ : nullptr;
    why_ = why_not;
  };
  if (query_ != nullptr && is_untold) {
    use(query, "");
    converted_->separation = 0;
  }
  if (query_ != nullptr && is_of_ends) {
    use(with_velocities(*query_),
        "takes velocities, and not all ends − positions of this query are doubles");
  }
  if (query_ != nullptr && is_weighted) {
    use(without_weights(*query_), "takes patches without weights, and those of this query differ");
  }
}

}  // namespace ccdfuzz
