#include "io/supervise.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace ccdfuzz {

namespace {

/// Kills the children, which orphans below them become then, until there are none. The list is read
/// once for all in it: a process with thousands of children must not gain time by that.
void end_descendants() {
  const std::string self = std::to_string(::getpid());
  const std::string list = "/proc/self/task/" + self + "/children";
  for (int killed = 1; killed > 0;) {
    FILE* const children = std::fopen(list.c_str(), "r");
    if (children == nullptr) return;
    killed = 0;
    for (int pid = 0; std::fscanf(children, "%d", &pid) == 1; ++killed) ::kill(pid, SIGKILL);
    std::fclose(children);
    for (int gone = 0; gone < killed; ++gone) {
      while (::waitpid(-1, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
  }
}

[[noreturn]] void end_by(int signal) {
  sigset_t all;
  sigfillset(&all);
  ::sigprocmask(SIG_UNBLOCK, &all, nullptr);
  ::signal(signal, SIG_DFL);
  ::raise(signal);
  std::_Exit(1);
}

[[noreturn]] void supervise(pid_t child, const sigset_t& awaited) {
  // A descriptor that the child closes must be closed here, too; stdin is for what it used.
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) ::close(descriptor);
  while (true) {
    int signal = 0;
    ::sigwait(&awaited, &signal);
    if (signal != SIGCHLD) {
      end_descendants();
      end_by(SIGKILL);
    }
    int status = 0;
    for (pid_t gone = 0; (gone = ::waitpid(-1, &status, WNOHANG)) > 0;) {
      if (gone != child) continue;
      end_descendants();
      rusage used{};
      ::getrusage(RUSAGE_CHILDREN, &used);
      const auto kibibytes = static_cast<std::uint64_t>(used.ru_maxrss);
      ::send(STDIN_FILENO, &kibibytes, sizeof kibibytes, MSG_DONTWAIT | MSG_NOSIGNAL);
      if (WIFSIGNALED(status)) end_by(WTERMSIG(status));
      std::_Exit(WEXITSTATUS(status));
    }
  }
}

void continue_below_a_watcher(pid_t parent) {
  // Where it is ignored (exec inherits that), waitpid does not report that a child has ended.
  ::signal(SIGCHLD, SIG_DFL);
  sigset_t awaited;
  sigset_t before;
  sigemptyset(&awaited);
  for (const int signal : {SIGCHLD, SIGTERM, SIGHUP}) sigaddset(&awaited, signal);
  ::sigprocmask(SIG_BLOCK, &awaited, &before);
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  ::prctl(PR_SET_PDEATHSIG, SIGHUP);
  if (::getppid() != parent) std::_Exit(1);  // it was gone before that
  const pid_t watcher = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) {
    std::fprintf(stderr, "%s: %s\n", kStartsNone, std::strerror(errno));
    std::_Exit(kStartsNoneCode);
  }
  if (child > 0) supervise(child, awaited);
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::signal(SIGXFSZ, SIG_DFL);  // as a plug-in expects it
  if (::getppid() != watcher) std::_Exit(1);
}

}  // namespace

void continue_in_supervised_child(pid_t starter) {
  continue_below_a_watcher(starter);
  ::setpgid(0, 0);  // so that the watcher above is not of it
  continue_below_a_watcher(::getppid());
}

}  // namespace ccdfuzz
