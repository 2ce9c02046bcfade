#include "method/process_end.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cctype>
#include <csignal>
#include <cstring>

namespace ccdfuzz {

namespace {

std::string signal_name(int number) {
  const char* const name = ::sigabbrev_np(number);
  return name == nullptr ? fmt::format("signal {}", number) : std::string("SIG") + name;
}

}  // namespace

void let_ends_be_known() {
  struct sigaction action {};
  ::sigaction(SIGCHLD, nullptr, &action);
  const bool ignored = action.sa_handler == SIG_IGN;
  if (!ignored && (action.sa_flags & SA_NOCLDWAIT) == 0) return;
  if (ignored) action.sa_handler = SIG_DFL;
  action.sa_flags &= ~SA_NOCLDWAIT;
  ::sigaction(SIGCHLD, &action, nullptr);
}

MethodFault fault_of_end(int status, std::uint64_t kibibytes_used, std::uint64_t megabytes_allowed,
                         const std::string& printed) {
  const std::string words = last_words(printed);
  if (kibibytes_used > megabytes_allowed << 9) {
    return {"memory", fmt::format("ended after it had used {} MiB of its {} MiB{}",
                                  kibibytes_used >> 10, megabytes_allowed, words)};
  }
  if (WIFSIGNALED(status)) {
    const std::string signal = signal_name(WTERMSIG(status));
    return {"crash " + signal, "ended by " + signal + words};
  }
  return {fmt::format("exit {}", WEXITSTATUS(status)),
          fmt::format("called exit({}){}", WEXITSTATUS(status), words)};
}

std::string last_words(std::string printed) {
  while (!printed.empty() && std::isspace(static_cast<unsigned char>(printed.back())) != 0) {
    printed.pop_back();
  }
  for (char& c : printed) {
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';
  }
  return printed.empty() ? "" : "; it printed: " + printed;
}

}  // namespace ccdfuzz
