#pragma once

#include "base/result.hpp"
#include "case/case.hpp"

namespace ccdfuzz {

// No file of cases is read here, nor in what this includes.

/// Checks in exact arithmetic all of a case's truth except absence of contact, which check_absence
/// does:
/// - the query is valid;
/// - a witness is a contact (check_contact), and a contact box or root holds one (check_box,
///   check_contact_root);
/// - collides = true has one of them with a time ≤ t_max, collides = false none;
/// - clear_until ≥ 0, and no contact is proven before it.
/// Errors: what is refuted, naming JSON path and value.
Result<void> check_truth(const Case& value);

/// Checks a certificate of absence of contact: check_plane, check_linear_clearance,
/// check_body_clearance, or check_tree, where a tree that is not known is a limit. Errors also: it
/// is about bodies and the query is not, or the other way round.
Result<void> check_clearance(const Query& query, const Clearance& clearance);

}  // namespace ccdfuzz
