#pragma once

#include <atomic>

namespace ccdfuzz {

/// Turns the first Ctrl-C (SIGINT) or SIGTERM into a flag that the command polls, so that it can
/// end in order; a second one ends the program at once.
/// Call it once; the flag lives as long as the program.
const std::atomic<bool>& catch_interrupts();

/// 128 + the signal that was caught, as shells report it: 130 after Ctrl-C.
int interrupted_exit_code();

}  // namespace ccdfuzz
