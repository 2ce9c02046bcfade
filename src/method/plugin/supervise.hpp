#pragma once

namespace ccdfuzz {

/// Parts the process in two. Returns in the child, which goes on as it is. Its parent waits for the
/// child to end, then ends all that the child has started and that lives on, in whatever session
/// and process group, and ends as the child did: by the same signal or with the same code. On
/// SIGTERM, or when whoever started the parent is gone, all of them end at once.
void continue_in_supervised_child();

}  // namespace ccdfuzz
