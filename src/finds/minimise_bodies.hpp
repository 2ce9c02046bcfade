#pragma once

#include "finds/minimise.hpp"

namespace ccdfuzz {

/// minimise for a case of bodies: fewer points, no radius, one that rests, about the origin, fewer
/// significant bits. Its truth is decided exactly each time (case_of_bodies); what that
/// says of the class of the contact stays. Numbers that are all floats stay so.
Minimised minimise_bodies(const Case& found, Outcome failure,
                          const std::function<bool(const Case&)>& still_fails,
                          const MinimiseOptions& options);

}  // namespace ccdfuzz
