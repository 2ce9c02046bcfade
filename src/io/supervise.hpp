#pragma once

#include <sys/types.h>

namespace ccdfuzz {

/// Splits the process into three: an upper watcher, a lower watcher, and its child. This function
/// returns in the child, which shares a process group with the lower watcher. starter: the process
/// that started this one, which ends at once if that is gone.
/// A watcher waits until the process below it ends. Then it ends all that this one has started, in
/// any session or process group. It ends in the same way itself: by the same signal or with the
/// same code. Before that it sends the most KiB that one of those had, in 64 bits, to stdin, which
/// is a socket. On SIGTERM, or when the process above it is gone, each ends at once.
/// So nothing survives where the child kills its parent or its process group. It must kill both
/// watchers, and the upper one is neither its parent nor in its group.
void continue_in_supervised_child(pid_t starter);

/// What a watcher prints that can start no process, on stderr, and its exit code: whoever hears
/// both does not blame the child, which never was. A served child says so of those that it starts.
inline constexpr const char* kStartsNone = "ccdfuzz: cannot start a process";
inline constexpr int kStartsNoneCode = 71;

}  // namespace ccdfuzz
