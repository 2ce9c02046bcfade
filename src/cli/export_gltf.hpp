#pragma once

#include <string>
#include <vector>

#include "numeric/result.hpp"

namespace ccdfuzz {

/// Writes cases as glTF: the one case of the files to `output` if that ends in .gltf, else each to
/// a file of its own in the folder `output`, called by its file's name (and line). times: as
/// to_gltf. Returns the paths that were written. Errors: a case that cannot be read; several for
/// one file; of the system.
Result<std::vector<std::string>> export_gltf(const std::vector<std::string>& files,
                                             const std::vector<double>& times,
                                             const std::string& output);

}  // namespace ccdfuzz
