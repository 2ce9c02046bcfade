#pragma once

#include "files/case_files.hpp"

namespace ccdfuzz {

/// Gives a linear query of a CSV its exact truth with certificates (decide). Every other case stays
/// as it is.
void decide_rows(NamedCase& named);

}  // namespace ccdfuzz
