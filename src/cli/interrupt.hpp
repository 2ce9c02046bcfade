#pragma once

#include <atomic>

namespace ccdfuzz {

/// How SIGINT (Ctrl-C), SIGTERM and SIGHUP end this program: at once, with exit code 128 + the
/// signal and without leaving a temporary file. What is on the disk is whole whenever that is, as
/// files appear whole and run files are read up to their last whole record. SIGPIPE, SIGQUIT and
/// SIGXCPU end it as they do by default, without leaving a temporary file either. A signal that was
/// ignored when the program was started stays ignored. SIGXFSZ is ignored, so that a file that
/// grows too large is an error of whoever writes it. Called once, by main.
void end_on_signals();

/// For a command that has results to print. The first signal sets the returned flag, which the
/// command polls. Two seconds later, or at a second signal, the program ends at once. The flag
/// lives as long as the program.
const std::atomic<bool>& catch_interrupts();

/// Takes that limit away, for a command that has stopped its work and writes what it has.
void finish_in_order();

/// 128 + the signal that was caught, as shells report it: 130 after Ctrl-C. The command has ended
/// in order.
int interrupted_exit_code();

}  // namespace ccdfuzz
