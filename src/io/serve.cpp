#include "io/serve.hpp"

#include <sys/time.h>

#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>

#include <fmt/format.h>

#include "base/no_process.hpp"
#include "io/process_limits.hpp"
#include "io/supervise.hpp"

namespace ccdfuzz {

namespace {

/// Certificates that the oracle makes may be long.
constexpr std::size_t kServedReplyBytes = std::size_t{256} << 20;

std::atomic<bool> this_program_serves = false;

/// Signals by which what crashes ends, unless a handler (a sanitizer's, say) makes something else
/// of them; and the one of the timer.
constexpr std::array kFatalSignals = {SIGSEGV, SIGBUS,  SIGFPE, SIGILL,
                                      SIGABRT, SIGTRAP, SIGSYS, SIGPROF};

/// SIGPROF ends this process once it has used this much more CPU time; 0: no longer.
void limit_cpu_seconds(double seconds) {
  double whole = 0;
  const auto micro = static_cast<suseconds_t>(std::modf(seconds, &whole) * 1e6);
  const itimerval once{{0, 0}, {static_cast<time_t>(whole), micro}};
  ::setitimer(ITIMER_PROF, &once, nullptr);
}

/// The work's answer, or the fault in place of it.
std::string worked(const std::function<std::string(const std::string&)>& work,
                   const std::string& question, bool& failed) {
  failed = true;
  try {
    std::string answer = work(question);
    failed = false;
    return answer;
  } catch (const std::bad_alloc&) {
    return to_json(Fault{"memory", "no more memory within its limit"});
  } catch (const NoProcess& none) {
    std::fprintf(stderr, "%s: %s\n", kStartsNone, none.what());
    std::_Exit(kStartsNoneCode);
  } catch (const std::exception& error) {
    return to_json(Fault{"exception", error.what()});
  } catch (...) {
    return to_json(Fault{"exception", "something that is no std::exception"});
  }
}

}  // namespace

void serve_lines(const std::function<std::string(const std::string&)>& work, double cpu_seconds) {
  for (const int signal : kFatalSignals) ::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  answer_lines([&](std::string_view question, int replies) {
    bool failed = false;
    limit_cpu_seconds(cpu_seconds);
    const std::string answer = worked(work, std::string(question), failed);
    limit_cpu_seconds(0);
    std::fflush(nullptr);
    if (write_all(replies, answer + "\n") != 0) std::_Exit(1);
    if (failed) std::_Exit(0);
  });
}

void serve_by_this_program() {
  this_program_serves = true;
}

Result<ChildProgram> served_child(const std::vector<std::string>& arguments,
                                  const ChildLimits& limits) {
  CCDFUZZ_TRY(const std::string program,
              this_program_serves ? this_program() : find_program("ccdfuzz", "CCDFUZZ_PROGRAM"));
  ChildProgram child{{"run", program, "serve"}, limits};
  if (limits.cpu_seconds > 0) {
    child.command.insert(child.command.end(),
                         {"--cpu-seconds", fmt::format("{}", limits.cpu_seconds)});
  }
  child.command.insert(child.command.end(), arguments.begin(), arguments.end());
  if (kReservesMemory) child.limits.megabytes = 0;
  child.limits.reply_bytes = kServedReplyBytes;
  return child;
}

}  // namespace ccdfuzz
