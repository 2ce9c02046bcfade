#include "run_apart.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include "io/process_limits.hpp"
#include "planted.hpp"
#include "property_turns.hpp"

#ifdef CCDFUZZ_COVERAGE
extern "C" void __gcov_dump();
#endif

namespace ccdfuzz {

namespace {

/// Ends this copy of the process, which leaves all that is not its own as it is. The lines that it
/// ran count: only here do properties say what refutes them.
[[noreturn]] void end_copy(int status) {
#ifdef CCDFUZZ_COVERAGE
  __gcov_dump();
#endif
  _exit(status);
}

/// Far above what a driver may take: it ends by itself, and Heartbeat ends a step that hangs. The
/// kernel counts full ticks, on a loaded machine a tenth more than were used.
rlim_t most_cpu_seconds(double seconds) {
  return static_cast<rlim_t>(2 * seconds) + 5;
}

void limit_process(double seconds) {
  // At the soft limit SIGXCPU comes, which nobody else sends; at the hard one it would be SIGKILL.
  rlimit cpu{};
  ::getrlimit(RLIMIT_CPU, &cpu);
  cpu.rlim_cur = std::min(most_cpu_seconds(seconds), cpu.rlim_max);
  ::setrlimit(RLIMIT_CPU, &cpu);
  if (!kReservesMemory) limit_resource(RLIMIT_AS, rlim_t{2} << 30);
  limit_resource(RLIMIT_CORE, 0);
}

/// What people and the system end a process by. No fault sends one of these, and neither do we.
bool is_from_outside(int signal) {
  return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP ||
         signal == SIGQUIT;
}

std::string death_text(int status, double seconds) {
  if (!WIFSIGNALED(status)) {
    return fmt::format("the process ends by itself: {}", WEXITSTATUS(status));
  }
  switch (const int signal = WTERMSIG(status)) {
    case SIGPROF:
      return fmt::format("it hangs: one step takes {} s", Heartbeat::kHang);
    case SIGXCPU:
      return fmt::format("it hangs: it takes {} s", most_cpu_seconds(seconds));
    default:
      return fmt::format("the process ends by signal {}", signal);
  }
}

Report death(int status, const rusage& usage, double seconds) {
  if (WIFSIGNALED(status) && is_from_outside(WTERMSIG(status))) {
    throw std::runtime_error(fmt::format("the run was ended from outside, by signal {} ({})",
                                         WTERMSIG(status), strsignal(WTERMSIG(status))));
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    throw std::runtime_error("the run ended without a report");
  }
  Report died;
  died.detected = died.died = true;
  died.seconds = static_cast<double>(usage.ru_utime.tv_sec) +
                 static_cast<double>(usage.ru_utime.tv_usec) * 1e-6;
  died.tell(death_text(status, seconds));
  return died;
}

}  // namespace

void Heartbeat::beat() {
  const double now = cpu_seconds_used();
  if (now - last_ < 0.1 * kHang) return;
  last_ = now;
  const itimerval once{{0, 0}, {static_cast<time_t>(kHang), 0}};
  setitimer(ITIMER_PROF, &once, nullptr);  // then SIGPROF
}

void Report::tell(std::string_view text) {
  constexpr std::string_view kCut = "…";
  std::string line(text.substr(0, text.find('\n')));
  if (line.size() >= sizeof found) {
    std::size_t end = sizeof found - 1 - kCut.size();
    while (end > 0 && (line[end] & 0xc0) == 0x80) --end;  // not amid a character
    line = line.substr(0, end).append(kCut);
  }
  line.copy(found, sizeof found - 1);
}

Report run_apart(
    int fault, double seconds,
    const std::function<void(const std::function<void(const DriverRun&)>& done)>& drive) {
  int ends[2];
  if (pipe(ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
  }
  // What it throws must not be caught by this process's own code, which it has a copy of.
  const auto work = [&]() noexcept {
    limit_process(seconds);
    planted::active_fault = fault;
    const double start = cpu_seconds_used();
    drive([&](const DriverRun& result) {
      Report report{planted::reached,
                    planted::triggered,
                    result.executions,
                    cpu_seconds_used() - start,
                    !result.found.empty(),
                    false,
                    ""};
      report.tell(result.found);
      [[maybe_unused]] const auto written = write(ends[1], &report, sizeof report);
      end_copy(0);
    });
    end_copy(0);  // without a report, which is no death
  };
  std::cout.flush();
  const pid_t parent = getpid(), child = fork();
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);  // it was gone before that
    // An open journal would stay locked for as long as this runs.
    close_range(STDERR_FILENO + 1, static_cast<unsigned>(ends[1]) - 1, 0);
    close_range(static_cast<unsigned>(ends[1]) + 1, ~0U, 0);
    work();
  }
  const int error = errno;
  close(ends[1]);
  Report report;
  const bool whole =
      child > 0 && read(ends[0], &report, sizeof report) == static_cast<ssize_t>(sizeof report);
  close(ends[0]);
  if (child < 0) throw std::system_error(error, std::generic_category(), "cannot start a process");
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child) {
    throw std::system_error(errno, std::generic_category(), "cannot wait for a process");
  }
  return whole ? report : death(status, usage, seconds);
}

}  // namespace ccdfuzz
