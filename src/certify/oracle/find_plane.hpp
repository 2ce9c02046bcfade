#pragma once

#include <optional>

#include "case/case.hpp"

namespace ccdfuzz {

/// A moving plane (certificate P) through a contact that separates the patches at all times before
/// it, or nothing. Its normal is one of those that the patches' tangents at the contact offer, or
/// their relative velocity there. What is returned passed check_plane. Requires a witness of the
/// query.
std::optional<MovingPlane> find_plane(const Query& query, const Witness& witness);

}  // namespace ccdfuzz
