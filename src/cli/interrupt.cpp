#include "cli/interrupt.hpp"

#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "io/output_file.hpp"

namespace ccdfuzz {

namespace {

/// Longer than an interrupted command may still wait for a child (ChildProgram::kPatience).
constexpr unsigned kSecondsToEnd = 2;

std::atomic<bool> was_interrupted = false;
std::atomic<bool> ends_in_order = false;
std::atomic<int> caught_signal = SIGINT;
std::atomic<pid_t> this_process = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may touch nothing else");

/// Everything here and below is safe in a signal handler.
[[noreturn]] void end_at_once() {
  remove_unfinished_files();
  ::_exit(128 + caught_signal);
}

void on_signal(int signal) {
  // A process that was forked and not started anew shares the handler: its parent ends it.
  if (::getpid() != this_process) return;
  if (signal == SIGALRM) end_at_once();
  const bool is_first = !was_interrupted.exchange(true);
  if (is_first) caught_signal = signal;
  if (!is_first || !ends_in_order) end_at_once();
  const int before = errno;
  ::alarm(kSecondsToEnd);
  errno = before;
}

/// Ends this process as the signal does where nobody handles it, which SA_RESETHAND makes so.
void on_deadly_signal(int signal) {
  if (::getpid() == this_process) remove_unfinished_files();
  ::raise(signal);
}

/// Whoever started this may have the signal ignored, and that stays. nohup ignores SIGHUP, and a
/// script SIGINT where it runs this in the background.
void handle_unless_ignored(int signal, const struct sigaction& action) {
  struct sigaction before {};
  sigaction(signal, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
}

}  // namespace

void end_on_signals() {
  this_process = ::getpid();
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGALRM, &action, nullptr);
  // SIGHUP: the terminal was closed.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle_unless_ignored(signal, action);
  action.sa_handler = on_deadly_signal;
  action.sa_flags = SA_RESETHAND;
  for (const int signal : {SIGPIPE, SIGQUIT, SIGXCPU}) handle_unless_ignored(signal, action);
  std::signal(SIGXFSZ, SIG_IGN);
}

const std::atomic<bool>& catch_interrupts() {
  ends_in_order = true;
  return was_interrupted;
}

void finish_in_order() {
  ::alarm(0);
}

int interrupted_exit_code() {
  finish_in_order();
  return 128 + caught_signal;
}

}  // namespace ccdfuzz
