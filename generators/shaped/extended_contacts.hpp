#pragma once

#include "generators/shaped/point_contacts.hpp"

namespace ccdfuzz {

/// Contacts of more than one point, all in the contact plane but for kArea, at t* = t_max = 1.
///
///   kSharedEdge  an edge of one patch is a part of an edge of the other, or all of it
///   kRuled       one patch touches the flat other one along a line of its parameters
///   kSeveral     one patch touches the straight other one in two points, or more
///   kArea        one patch is a part of the other: both flat, or curved and moved by one velocity
///
/// The contact that the scene names is one of them. Before t* the plane separates the patches, but
/// curved ones in kArea, and kSeveral of FF, whose heights the checker does not see to be ≥ 0.
/// Requires can_extend.
ContactScene extended_contact(Family family, ContactClass contact, const ShapePair& shapes,
                              Draw& draw);

/// True iff these shapes can have such a contact.
bool can_extend(Family family, ContactClass contact, const ShapePair& shapes);

}  // namespace ccdfuzz
