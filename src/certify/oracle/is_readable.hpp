#pragma once

#include "case/case.hpp"

namespace ccdfuzz {

/// Whether a file may hold all numbers of a truth: it is of a case that is read again
/// (kMaxRationalDigits). Likewise of its parts.
bool is_readable(const Truth& truth);
bool is_readable(const Witness& witness);
bool is_readable(const ContactRoot& root);

}  // namespace ccdfuzz
