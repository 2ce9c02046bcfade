#pragma once

#include <optional>
#include <string>
#include <vector>

#include "query/case.hpp"

namespace ccdfuzz {

/// A case as glTF 2.0, one JSON text with its buffer in it: the surfaces of both patches, their
/// control nets, and a node at the witness's point.
/// times: the patches once for each, as nodes of their own; or none, for an animation in which a
/// second of film is the whole step [0, t_max] (control points move linearly, so two shapes say it
/// exactly).
/// glTF has single precision: lengths are relative to the contact (or to the first control point,
/// where there is no witness), and multiplied by a power of two where they would leave its range.
/// The asset's `extras` say by what.
/// Requires a valid query, and finite times.
std::string to_gltf(const Case& value, const std::vector<double>& times);

}  // namespace ccdfuzz
