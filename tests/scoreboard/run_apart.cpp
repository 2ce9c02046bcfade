#include "run_apart.hpp"

#include <fmt/format.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <stdexcept>

#include "method/process_limits.hpp"
#include "property_turns.hpp"
#include "scoreboard/planted.hpp"

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

/// Far above what a driver may take, which ends by itself, and of which a step that hangs is ended
/// by Heartbeat: the kernel counts whole ticks, on a loaded machine a tenth more than were used.
void limit_process(double seconds) {
  limit_resource(RLIMIT_CPU, static_cast<rlim_t>(2 * seconds) + 5);
  if (!kReservesMemory) limit_resource(RLIMIT_AS, rlim_t{2} << 30);
  limit_resource(RLIMIT_CORE, 0);
}

Report death(int status, const rusage& usage) {
  Report died;
  died.detected = died.died = true;
  died.seconds = static_cast<double>(usage.ru_utime.tv_sec) +
                 static_cast<double>(usage.ru_utime.tv_usec) * 1e-6;
  const std::string what = !WIFSIGNALED(status)
                               ? fmt::format("the process ends by itself: {}", WEXITSTATUS(status))
                           : WTERMSIG(status) == SIGPROF
                               ? fmt::format("it hangs: one step takes {} s", Heartbeat::kHang)
                               : fmt::format("the process ends by signal {}", WTERMSIG(status));
  what.copy(died.found, sizeof died.found - 1);
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

Report run_apart(
    int fault, double seconds,
    const std::function<void(const std::function<void(const DriverRun&)>& done)>& drive) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
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
      const std::string line = result.found.substr(0, result.found.find('\n'));
      line.copy(report.found, sizeof report.found - 1);
      [[maybe_unused]] const auto written = write(ends[1], &report, sizeof report);
      end_copy(0);
    });
    end_copy(1);
  }
  close(ends[1]);
  Report report;
  const bool whole = read(ends[0], &report, sizeof report) == static_cast<ssize_t>(sizeof report);
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  return whole ? report : death(status, usage);
}

}  // namespace ccdfuzz
