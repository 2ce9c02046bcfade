#include "cli/interrupt.hpp"

#include <csignal>

namespace ccdfuzz {

namespace {

std::atomic<bool> was_interrupted = false;
std::atomic<int> caught_signal = SIGINT;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may touch nothing else");

void note_interrupt(int signal) {
  caught_signal = signal;
  was_interrupted = true;
}

}  // namespace

const std::atomic<bool>& catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  // The second signal finds the default action again.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // The terminal was closed; under nohup it is ignored, and stays so.
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
  return was_interrupted;
}

int interrupted_exit_code() {
  return 128 + caught_signal;
}

}  // namespace ccdfuzz
