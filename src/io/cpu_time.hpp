#pragma once

namespace ccdfuzz {

/// CPU time that the calling thread has used, in seconds.
double thread_cpu_seconds();

}  // namespace ccdfuzz
