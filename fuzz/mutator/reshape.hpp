#pragma once

#include "generators/contact.hpp"

namespace ccdfuzz {

/// Patch `side` by parameters in another order; the move of the witness with it. way: any number.
void reparametrise_patch(Contact& q, size_t side, std::uint64_t way);

/// Patch `side` with one degree more; of a tensor patch in u or v. Returns false if a control point
/// is not a double then (it is divided by the new degree), or the degree is at its limit.
bool elevate_patch(Contact& q, size_t side, bool in_v);

/// The child cell of patch `side` that holds the contact. Returns false if it is not exact.
bool restrict_patch(Contact& q, size_t side);

}  // namespace ccdfuzz
