#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"
#include "case/case.hpp"

namespace ccdfuzz {

/// Checks what a case says of itself against exact arithmetic, but for what takes long:
///   the query is valid;
///   a witness is a contact (check_contact), and a contact box or root holds one (check_box,
///   check_contact_root);
///   collides = true has one of them with a time ≤ t_max, collides = false none;
///   clear_until ≥ 0, and no contact is proven before it.
/// Not checked here: that absence of contact really holds, which is check_absence. Errors: what is
/// refuted, naming JSON path and value.
Result<void> check_truth(const Case& value);

/// Checks a certificate of absence of contact: check_plane, check_linear_clearance, or check_tree
/// of these bytes.
Result<void> check_clearance(const Query& query, const Clearance& clearance, std::string_view tree);

/// Checks that the case's clearance holds and proves all that the case says of absence: no contact
/// in the closed [0, t_max] if collides is false, none in the half-open [0, clear_until). trees:
/// the file of trees beside the case, read if the clearance is a tree. Errors: what is missing or
/// refuted, naming JSON path, or the file.
Result<void> check_absence(const Case& value, const std::string& trees);

}  // namespace ccdfuzz
