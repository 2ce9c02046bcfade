#pragma once

#include "finds/asker.hpp"
#include "finds/minimise.hpp"

namespace ccdfuzz {

/// Minimises a case that shows a failure: every simpler one that is taken shows the same failure.
/// One whose patches pass through each other stays at least half as deep, relative to its size.
/// The result expects this failure alone, and has no name. For a hang only a few trials are
/// made, since each costs all of its time.
Minimised shrink(const Case& found, const Failure& failure, Asker& asker,
                 MinimiseOptions options = {});

}  // namespace ccdfuzz
