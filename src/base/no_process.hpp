#pragma once

#include <stdexcept>

namespace ccdfuzz {

/// Thrown where no process answers, which is no fault of what it was to run. The system refuses
/// one, a program is not there any more, or who asks was interrupted. It ends a command.
struct NoProcess : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace ccdfuzz
