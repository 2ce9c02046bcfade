#include "certify/checker/check_truth.hpp"

#include "certify/checker/abbreviated.hpp"
#include "certify/checker/check_bodies.hpp"
#include "certify/checker/check_box.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_turning.hpp"
#include "certify/checker/check_witness.hpp"

namespace ccdfuzz {

Result<void> check_truth(const Case& value) {
  const Truth& truth = value.truth;
  if (auto fault = fault_of(value.query)) return tl::unexpected(*std::move(fault));
  if (is_of_bodies(value.query) && (truth.contact_box || truth.contact_root)) {
    return input_error("truth.certificate", "proves nothing of bodies");
  }
  if (truth.collides == true && !truth.contact_by()) {
    return input_error("truth.witness", "missing, though collides is true");
  }
  if (truth.witness) {
    const bool is_proof = truth.collides == true && !truth.contact_box && !truth.contact_root;
    CCDFUZZ_TRY_VOID(is_proof ? check_witness(value.query, *truth.witness)
                              : check_contact(value.query, *truth.witness));
  }
  if (truth.contact_box) {
    CCDFUZZ_TRY_VOID(check_box(value.query, *truth.contact_box));
  }
  if (truth.contact_root) {
    CCDFUZZ_TRY_VOID(check_contact_root(value.query, *truth.contact_root));
  }
  const std::optional<Rational> by = truth.contact_by();
  const char* const proof = truth.witness && truth.witness->t == by              ? "witness"
                            : truth.contact_root && truth.contact_root->by == by ? "contact root"
                                                                                 : "contact box";
  if (truth.collides == true && *by > exact(value.query.t_max)) {
    return input_error("truth.collides", "true, but the contact is proven only by t = {} > t_max",
                       abbreviated(*by));
  }
  if (truth.collides == false && by && *by <= exact(value.query.t_max)) {
    return input_error("truth.collides", "false, but the {} proves a contact at t = {} ≤ t_max",
                       proof, abbreviated(*by));
  }
  if (truth.clear_until) {
    const std::string until = abbreviated(*truth.clear_until);
    if (*truth.clear_until < 0) {
      return input_error("truth.clear_until", "{} is negative", until);
    }
    if (by && *by < *truth.clear_until) {
      return input_error("truth.clear_until", "{}, but the {} proves a contact at t = {} before it",
                         until, proof, abbreviated(*by));
    }
  }
  return {};
}

Result<void> check_clearance(const Query& query, const Clearance& clearance) {
  const auto* bodies = std::get_if<BodyClearance>(&clearance);
  const auto* planes = std::get_if<BodyPlanes>(&clearance);
  const auto* faces = std::get_if<MeshClearance>(&clearance);
  const bool is_about_bodies = bodies != nullptr || planes != nullptr || faces != nullptr;
  if (is_of_bodies(query) != is_about_bodies) {
    return input_error("truth.certificate.clear",
                       is_about_bodies ? "is about bodies alone" : "proves nothing of bodies");
  }
  if (planes != nullptr) return check_body_planes(query, *planes);
  if (faces != nullptr) return check_mesh_clearance(query, *faces);
  if (bodies != nullptr) return check_body_clearance(query, *bodies);
  if (const auto* plane = std::get_if<MovingPlane>(&clearance)) return check_plane(query, *plane);
  if (const auto* linear = std::get_if<LinearClearance>(&clearance)) {
    return check_linear_clearance(query, *linear);
  }
  const auto& [until, tree] = std::get<MissTree>(clearance);
  if (tree.bytes.empty()) {
    return tl::unexpected(InputError{
        "truth.certificate.clear.tree",
        "stood in a file beside the case, which is read no more; `ccdfuzz prove` makes another",
        true});
  }
  return check_tree(query, until, tree.bytes).map([](std::uint64_t) {});
}

}  // namespace ccdfuzz
